// Percentiles by the nearest-rank method, whose result is always one of the values.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <functional>
#include <vector>

namespace plumbline {

/// Index, in ascending order, of the smallest of `count` values such that at least `percent` % of the values
/// don't exceed it: ceil(percent/100 * count) - 1, computed in integers so that rounding can't make it off by
/// one. count >= 1, percent in [1, 100].
inline size_t nearestRankIndex(size_t count, unsigned percent) {
    assert(count > 0 && percent >= 1 && percent <= 100);
    return (count * percent + 99) / 100 - 1;
}

/// The element of that rank by its projection. `values`: in any order, not empty; left in another one.
template <class Values, class Projection = std::identity>
typename Values::value_type nearestRankInPlace(Values& values, unsigned percent, Projection by = {}) {
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(nearestRankIndex(values.size(), percent));
    std::ranges::nth_element(values, nth, {}, by);
    return *nth;
}

/// The value of that rank, not of none.
inline double nearestRank(std::vector<double> values, unsigned percent) {
    return nearestRankInPlace(values, percent);
}

} // namespace plumbline
