// Names a parameter can't have, and words in GLSL text.
#pragma once

#include <optional>
#include <string>

namespace plumbline {

/// A keyword, reserved word, type or built-in function of GLSL 4.10 or GLSL ES 3.00.
bool isGlslWord(const std::string& name);
/// A name the harness declares: a setting of its own or a function of the contract.
bool isHarnessName(const std::string& name);

/// A byte of GLSL text, outside of comments, that isn't ASCII: no compiler says a sensible word of it.
struct GlslByte {
    int line;
    unsigned char value;
};
std::optional<GlslByte> firstForeignByte(const std::string& glsl);

} // namespace plumbline
