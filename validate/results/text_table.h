// A table for the terminal: the first column to the left, the others to the right.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

class TextTable {
  public:
    explicit TextTable(std::vector<std::string> heads) { rows_.push_back(std::move(heads)); }
    /// As many cells as there are heads.
    void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    bool empty() const { return rows_.size() == 1; }
    /// A line a row, the heads first. Widths are those of UTF-8 characters.
    std::string text() const;

  private:
    size_t widthOf(size_t column) const;

    std::vector<std::vector<std::string>> rows_;
};

} // namespace plumbline
