// Values of header fields as words with blanks between, both directions.
#pragma once

#include "scenes/core/math.h"

#include <sstream>
#include <string>

namespace plumbline {

/// "x y z", each with as many digits as it takes to read it back bit for bit.
std::string headerText(const Vec3& vector);

/// Words of a header value, taken one by one; any word that isn't what is asked for makes the value
/// unreadable.
class HeaderWords {
  public:
    explicit HeaderWords(const std::string& text);

    std::string word();
    void literal(const char* expected);
    double number();
    /// A whole number from 1 to `largest`.
    int count(int largest);
    Vec3 vector();
    /// Whether the word is `yes`; it must be that or `no`.
    bool either(const char* yes, const char* no);
    /// Whether everything was as asked for and nothing is left.
    bool ok();

  private:
    std::istringstream stream_;
    bool failed_ = false;
};

/// Throws the InputError for a value that can't be read; `where`: the file.
[[noreturn]] void refuseHeaderField(const std::string& where, const std::string& key,
                                    const std::string& value, const std::string& expected);

} // namespace plumbline
