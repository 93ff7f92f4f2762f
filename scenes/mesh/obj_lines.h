// The lines of a Wavefront OBJ text as programs of all systems write it.
//
// Line endings are LF, CR LF or CR; the last line may lack one. A byte-order mark at the start, and zero
// bytes or a Ctrl-Z (the end-of-text mark of DOS) at the end aren't part of the text. A backslash at the end
// of a line joins it with the next one, except where it ends a name (`usemtl C:\maps\`, or a letter of
// Shift-JIS). A comment begins with a # at the start of a word.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// What separates the words of a line.
inline constexpr std::string_view kObjBlanks = " \t\v\f";

class ObjLines {
  public:
    /// `text` must outlive this object.
    explicit ObjLines(std::string_view text);

    /// Moves to the next line. False at the end of the text.
    bool next();
    /// Without its ending and comment.
    std::string_view line() const { return line_; }
    /// From 1; for joined lines, the number of the first one.
    int number() const { return number_; }
    /// The number of the first line of the text with a zero byte, comments included; 0 if there is none.
    int lineWithZero() const;

  private:
    std::string_view take(bool& continues);

    std::string_view text_, rest_, line_;
    std::string joined_;
    int number_ = 1, linesTaken_ = 0;
};

} // namespace plumbline
