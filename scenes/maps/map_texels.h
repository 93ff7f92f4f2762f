// Helpers for generated maps: seeded random numbers, a sine that is bit-identical on all machines, and a
// parallel loop over texels.
#pragma once

#include "scenes/core/index.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace plumbline {

/// Mixes 64 bits (the finalizer of SplitMix64: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number
/// Generators", 2014).
inline uint64_t mixBits(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// In [0,1), a multiple of 2^-53; a different number for each seed, `purpose` and position.
inline double randomAt(unsigned seed, uint32_t purpose, int i, int j = 0) {
    const uint64_t place = (uint64_t(uint32_t(i)) << 32) | uint32_t(j);
    const uint64_t bits = mixBits(mixBits((uint64_t(seed) << 32) | purpose) ^ place);
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// sin(2 pi turns). Taylor series on a quarter turn, error below 1e-13: far below a float's last bit, and the
/// same bits on every machine, which std::sin does not promise.
inline double sineOfTurns(double turns) {
    double x = turns - std::floor(turns); // [0,1)
    double sign = 1;
    if (x >= 0.5) {
        x -= 0.5;
        sign = -1;
    }
    if (x > 0.25) x = 0.5 - x;
    const double angle = x * 6.283185307179586477, square = angle * angle;
    double series = 1;
    for (int k = 17; k >= 3; k -= 2)
        series = 1 - square / (k * (k - 1)) * series;
    return sign * angle * series;
}

/// size x size texels, row 0 at the bottom; `depth(i, j)` is clamped to [0,1].
template <typename Depth>
std::vector<float> fillTexels(int size, Depth depth) {
    std::vector<float> texels(areaOf(size, size));
    tbb::parallel_for(tbb::blocked_range<int>(0, size, 16), [&](const tbb::blocked_range<int>& rows) {
        for (int j = rows.begin(); j < rows.end(); ++j)
            for (int i = 0; i < size; ++i)
                texels[indexIn(size, i, j)] =
                    static_cast<float>(std::clamp(static_cast<double>(depth(i, j)), 0.0, 1.0));
    });
    return texels;
}

/// Rescales the values to [0,1]; a constant map stays unchanged.
inline void stretchToFullRange(std::vector<float>& texels) {
    const auto [low, high] = std::minmax_element(texels.begin(), texels.end());
    const double least = *low, range = static_cast<double>(*high) - least;
    if (!(range > 0)) return;
    for (float& texel : texels)
        texel = static_cast<float>((texel - least) / range);
}

} // namespace plumbline
