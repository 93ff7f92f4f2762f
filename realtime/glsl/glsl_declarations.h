// What a piece of GLSL declares at file scope.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace plumbline {

/// Names of functions (prototypes included), variables, constants, inputs, outputs, uniforms, structures,
/// interface blocks (of one without an instance name the members too) and macros. A second declaration of one
/// of them at file scope is an error, or changes what the text after it means. The text must compile; it
/// isn't preprocessed: declarations in every branch of an #if count.
std::set<std::string> fileScopeNames(std::string_view glsl);

} // namespace plumbline
