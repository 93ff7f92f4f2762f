// Checks the nesting depth of the tables of a TOML text before a parser recurses into them.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// Throws InputError for dotted keys, also in inline tables, that nest so many tables that the parser's
/// recursion would overflow the stack. The parser itself limits nested values.
void checkKeyDepth(const std::string& where, std::string_view text);

} // namespace plumbline
