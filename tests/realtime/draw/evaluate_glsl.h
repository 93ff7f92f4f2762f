// Runs a GLSL function over a list of arguments on the GPU, so that it can be compared with the C++ version.
#pragma once

#include "realtime/gl/gl_program.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace plumbline {

/// `functions` must define `vec4 evaluate(vec4 argument)`. `setUp` is called with the program in use, before
/// drawing. A context must be current.
std::vector<glm::vec4> evaluateGlsl(ShaderSource functions, const std::vector<glm::vec4>& arguments,
                                    const std::function<void(const GlProgram&)>& setUp = {});

} // namespace plumbline
