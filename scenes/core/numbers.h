// Parses numbers, in the same way for options, manifests, frame headers and OBJ tags.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <optional>
#include <string_view>
#include <system_error>

namespace plumbline {

/// Parses all of `text` as one number with std::from_chars, independently of the locale: no surrounding
/// whitespace and no leading '+'. Returns nothing if the text isn't a number, if `Number` can't represent it,
/// and for "inf" and "nan".
template <class Number>
std::optional<Number> parseNumber(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stopped != end) return std::nullopt;
    if constexpr (std::floating_point<Number>)
        if (!std::isfinite(number)) return std::nullopt;
    return number;
}

} // namespace plumbline
