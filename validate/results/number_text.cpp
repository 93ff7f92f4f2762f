#include "validate/results/number_text.h"

#include <fmt/format.h>

namespace plumbline {

std::string numberText(std::string_view format, double value) {
    const std::string text = fmt::format(fmt::runtime(format), value);
    const bool negativeZero = text.starts_with("-0") && text.find_first_not_of("-0.") == std::string::npos;
    return negativeZero ? fmt::format(fmt::runtime(format), 0.0) : text;
}

} // namespace plumbline
