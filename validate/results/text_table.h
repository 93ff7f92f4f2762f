// A table for the terminal. The first column is left-aligned, the others are right-aligned.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

class TextTable {
  public:
    explicit TextTable(const std::vector<std::string>& heads) { add(heads); }
    /// `cells`: as many as there are heads. They are shown as printable() makes them.
    void add(const std::vector<std::string>& cells);
    bool empty() const { return rows_.size() == 1; }
    /// One line per row, the heads first. Widths count UTF-8 characters.
    std::string text() const;

  private:
    size_t widthOf(size_t column) const;

    std::vector<std::vector<std::string>> rows_;
};

} // namespace plumbline
