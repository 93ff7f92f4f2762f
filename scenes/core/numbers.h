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
/// whitespace and no leading '+'. Returns nothing if the text isn't a number, if `Number` can't represent it
/// (too large, or not 0 and too small), and for "inf" and "nan".
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

/// Like parseNumber, but takes one leading '+', as numbers and indices of OBJ files may have.
template <class Number>
std::optional<Number> parseSignedNumber(std::string_view text) {
    if (!text.starts_with('+')) return parseNumber<Number>(text);
    text.remove_prefix(1);
    return text.starts_with('-') ? std::nullopt : parseNumber<Number>(text);
}

} // namespace plumbline
