// Writes comma-separated values, RFC 4180.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// As printable() makes it, quoted if necessary.
std::string csvCell(const std::string& text);
/// Ends with CR LF.
std::string csvLine(const std::vector<std::string>& texts);

} // namespace plumbline
