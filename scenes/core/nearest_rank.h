// Percentiles by nearest rank: always one of the values.
#pragma once

#include <cstddef>

namespace plumbline {

/// Index, in ascending order, of the smallest of `count` values that at least `percent` % of them don't
/// exceed: rank ceil(percent/100 * count) less 1, in integers, so that it can't be off by one through
/// rounding. count >= 1, percent in [1, 100].
inline size_t nearestRankIndex(size_t count, unsigned percent) {
    return (count * percent + 99) / 100 - 1;
}

} // namespace plumbline
