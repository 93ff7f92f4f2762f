// Reserved names that parameters can't have, and identifiers in GLSL text.
#pragma once

#include <optional>
#include <string>

namespace plumbline {

/// A keyword, reserved word, type or built-in function of GLSL 4.10 or GLSL ES 3.00.
bool isGlslWord(const std::string& name);
/// A name that the harness declares: a setting or a function of relief_contract.glsl.
bool isHarnessName(const std::string& name);

/// A byte of GLSL text outside comments that isn't ASCII, for which compilers give unhelpful messages.
struct GlslByte {
    int line;
    unsigned char value;
};
std::optional<GlslByte> firstForeignByte(const std::string& glsl);

} // namespace plumbline
