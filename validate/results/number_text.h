// Figures as text for a person.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// The number in a format of fmt, for example "{:.4f}". One that rounds to zero has no minus sign.
std::string numberText(std::string_view format, double value);

} // namespace plumbline
