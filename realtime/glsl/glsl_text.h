// Words in GLSL text: which are the language's own, and whether a text uses one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

/// A letter, digit or underscore.
bool isNameCharacter(char c);

/// A keyword, reserved word, type or built-in function of GLSL 4.10 (sections 3.6 and 8) or GLSL ES 3.00
/// (sections 3.7 and 8).
bool isGlslWord(std::string_view name);

/// The text with spaces in place of comments; lines keep their numbers.
std::string withoutComments(std::string_view glsl);

/// Whether `name` stands in GLSL text as a whole word, outside of comments.
bool namesIdentifier(std::string_view glsl, std::string_view name);

/// A byte of GLSL text, outside of comments, that isn't ASCII: compilers report those in ways that don't
/// help.
struct GlslByte {
    int line;
    unsigned char value;
};
std::optional<GlslByte> firstNonAsciiByte(std::string_view glsl);

} // namespace plumbline
