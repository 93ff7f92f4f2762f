// Texts to numbers, the one way everywhere: options, manifests, headers of frames, OBJ tags.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <optional>
#include <string_view>
#include <system_error>

namespace plumbline {

/// The number that all of `text` is, as std::from_chars reads it whatever the locale: without blanks around
/// it and without a '+'. Nothing for a text that isn't one, for a number that `Number` can't hold, and for
/// "inf" and "nan".
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
