// One axis of a bilinear lookup, shared by height maps and color maps (conventions: height_map.h).
#pragma once

#include "scenes/maps/height_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumbline {

/// The two texels around a coordinate, wrapped, and the weight of the second, in [0,1].
struct TexelPair {
    int first = 0, second = 0;
    double weight = 0;
};

/// s - floor(s), in [0,1]; 1 for a negative number so small that the difference rounds to 1. NaN if s isn't
/// finite.
inline double repeatUnit(double s) {
    constexpr double kAllIntegersFrom = 4503599627370496.0; // 2^52: larger doubles have no fractional part
    if (!(std::abs(s) < kAllIntegersFrom)) return s - s;    // 0, or NaN for NaN and infinities
    const double truncated = static_cast<double>(static_cast<long long>(s));
    return s - (truncated > s ? truncated - 1.0 : truncated);
}

/// Texel centers are at (i + 0.5) / size. The coordinate must not be NaN, nor infinite under Wrap::Repeat. At
/// a texel center, the first texel of the pair is that texel.
inline TexelPair texelPair(double s, int size, Wrap wrap) {
    const bool repeat = wrap == Wrap::Repeat;
    assert(size > 0 && (repeat ? std::isfinite(s) : !std::isnan(s)));
    const double texels = (repeat ? repeatUnit(s) : s) * size - 0.5;
    const double inReach = std::clamp(texels, -1.0, static_cast<double>(size)); // only affects Wrap::Clamp
    TexelPair pair;
    pair.first = static_cast<int>(inReach + 1.0) - 1; // floor, as inReach + 1 >= 0
    // Just below an integer, x + 1 may round up to it, which would give a wrong floor(x).
    if (pair.first > inReach) --pair.first;
    pair.weight = inReach - pair.first;
    pair.second = pair.first + 1;
    if (repeat) {
        if (pair.first < 0) pair.first += size;
        if (pair.second >= size) pair.second -= size;
    } else {
        pair.first = std::clamp(pair.first, 0, size - 1);
        pair.second = std::clamp(pair.second, 0, size - 1);
    }
    return pair;
}

} // namespace plumbline
