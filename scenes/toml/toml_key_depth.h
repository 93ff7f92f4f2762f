// How deep the tables of a TOML text will be, before a parser recurses into them.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// Throws InputError for dotted keys that make more tables within each other than a stack holds of a parser's
/// steps, also through inline tables; nested values the parser limits itself.
void checkKeyDepth(const std::string& where, std::string_view text);

} // namespace plumbline
