#include "scenes/mesh/obj_lines.h"

#include "scenes/core/contains.h"

#include <algorithm>
#include <array>

namespace plumbline {
namespace {

constexpr std::array<std::string_view, 6> kNameKeywords{"o", "g", "usemtl", "mtllib", "usemap", "maplib"};

/// Whether the backslash that ends the line is part of a name. Such a line names something, and the backslash
/// isn't a word of its own.
bool endsInName(std::string_view line) {
    const size_t begin = std::min(line.find_first_not_of(kObjBlanks), line.size());
    const size_t end = std::min(line.find_first_of(kObjBlanks, begin), line.size());
    if (!contains(kNameKeywords, line.substr(begin, end - begin))) return false;
    return kObjBlanks.find(line[line.size() - 2]) == kObjBlanks.npos;
}

/// Where the comment begins; npos if there is none. A '#' within a word isn't one: a common C library writes
/// numbers that aren't finite as 1.#IND.
size_t commentIn(std::string_view line) {
    for (size_t at = line.find('#'); at != line.npos; at = line.find('#', at + 1))
        if (at == 0 || kObjBlanks.find(line[at - 1]) != kObjBlanks.npos) return at;
    return line.npos;
}

} // namespace

ObjLines::ObjLines(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (!text.empty() && (text.back() == '\0' || text.back() == '\x1a'))
        text.remove_suffix(1);
    text_ = rest_ = text;
}

bool ObjLines::next() {
    number_ += linesTaken_;
    linesTaken_ = 0;
    if (rest_.empty()) return false;
    bool continues = false;
    line_ = take(continues);
    if (!continues) return true;
    joined_ = line_;
    while (continues) {
        joined_ += ' ';
        joined_ += take(continues);
    }
    line_ = joined_;
    return true;
}

std::string_view ObjLines::take(bool& continues) {
    const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    std::string_view line = rest_.substr(0, end);
    const bool isLast = end == rest_.size();
    rest_.remove_prefix(end);
    if (!isLast) rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
    ++linesTaken_;
    const size_t comment = commentIn(line);
    continues = !isLast && comment == line.npos && line.ends_with('\\') && !endsInName(line);
    if (continues) line.remove_suffix(1);
    return line.substr(0, comment);
}

int ObjLines::lineWithZero() const {
    const std::string_view before = text_.substr(0, text_.find('\0'));
    if (before.size() == text_.size()) return 0;
    int line = 1;
    for (size_t i = 0; i < before.size(); ++i)
        if (before[i] == '\n' || (before[i] == '\r' && !before.substr(i).starts_with("\r\n"))) ++line;
    return line;
}

} // namespace plumbline
