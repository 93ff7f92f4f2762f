// Text of a file, a header or a folder's name as it may be shown to a person.
//
// Such texts are kept as they are while they name something (a channel, a light, a path), and made printable
// where they are written for a person: in errors, tables, notes, CSV, Markdown and pages. JSON escapes them
// instead.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// The text with blanks for characters that would do something to a terminal or a line of text instead of
/// being shown: control characters (C0, DEL, C1), line separators, and those that change the direction of
/// writing. Bytes that aren't UTF-8 become U+FFFD, as a terminal may take them for C1.
std::string printable(std::string_view text);

} // namespace plumbline
