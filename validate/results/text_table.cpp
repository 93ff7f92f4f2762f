#include "validate/results/text_table.h"

#include "scenes/core/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

/// Number of UTF-8 characters, that is, of bytes that don't continue one.
size_t characters(const std::string& text) {
    return static_cast<size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

} // namespace

void TextTable::add(const std::vector<std::string>& cells) {
    std::vector<std::string>& row = rows_.emplace_back();
    for (const std::string& cell : cells)
        row.push_back(printable(cell));
}

std::string TextTable::text() const {
    std::string text;
    for (const auto& row : rows_) {
        for (size_t column = 0; column < row.size(); ++column)
            text += column == 0 ? fmt::format("{:<{}}", row[column], widthOf(column))
                                : fmt::format("  {:>{}}", row[column], widthOf(column));
        text += "\n";
    }
    return text;
}

size_t TextTable::widthOf(size_t column) const {
    size_t width = 0;
    for (const auto& row : rows_)
        width = std::max(width, characters(row[column]));
    return width;
}

} // namespace plumbline
