// std::ranges::contains of C++23.
#pragma once

#include <algorithm>
#include <ranges>

namespace plumbline {

/// Whether one of a range's elements equals a value.
template <std::ranges::input_range Range, class Value>
bool contains(const Range& range, const Value& value) {
    return std::ranges::find(range, value) != std::ranges::end(range);
}

} // namespace plumbline
