// Height maps for tests of bakers: degenerate sizes, and noise.
#pragma once

#include "scenes/maps/height_map.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <random>

namespace plumbline::test {

inline HeightMap noiseMap(int width, int height, unsigned seed, Wrap wrapS = Wrap::Repeat,
                          Wrap wrapT = Wrap::Repeat) {
    std::mt19937 random(seed);
    std::vector<float> depths(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (float& depth : depths)
        depth = static_cast<float>(random() >> 8) * 0x1p-24f;
    return HeightMap(fmt::format("noise {} x {}", width, height), width, height, std::move(depths), wrapS,
                     wrapT);
}

/// A floor of depth 1 with one texel of depth 0.
inline HeightMap needleMap(int width, int height, int column, int row, Wrap wrapS = Wrap::Repeat,
                           Wrap wrapT = Wrap::Repeat) {
    std::vector<float> depths(static_cast<size_t>(width) * static_cast<size_t>(height), 1.0f);
    depths[static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(column)] = 0;
    return HeightMap("needle", width, height, std::move(depths), wrapS, wrapT);
}

/// With all wrap modes: one texel, a row, a column, sizes that aren't powers of two, a constant, a needle.
inline std::vector<HeightMap> awkwardMaps() {
    std::vector<HeightMap> maps;
    for (const Wrap s : {Wrap::Repeat, Wrap::Clamp})
        for (const Wrap t : {Wrap::Repeat, Wrap::Clamp}) {
            constexpr int kSizes[][2] = {{1, 1}, {1, 7}, {9, 1}, {2, 2}, {7, 5}, {3, 16}, {13, 8}};
            for (const auto& [width, height] : kSizes)
                maps.push_back(noiseMap(width, height, static_cast<unsigned>(17 * width + height), s, t));
            for (const float depth : {0.0f, 0.4f, 1.0f})
                maps.emplace_back("constant", 5, 4, std::vector<float>(20, depth), s, t);
            maps.push_back(needleMap(11, 6, 0, 5, s, t));
        }
    return maps;
}

inline std::string describe(const HeightMap& map) {
    const auto name = [](Wrap wrap) { return wrap == Wrap::Repeat ? "repeat" : "clamp"; };
    return fmt::format("{}, {} x {}, {} {}, first depth {}", map.name(), map.width(), map.height(),
                       name(map.wrapS()), name(map.wrapT()), map.depths()[0]);
}

/// Compares bits, so that NaNs can be equal.
inline bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
        return std::bit_cast<uint32_t>(x) == std::bit_cast<uint32_t>(y);
    });
}

/// The result of `make` on one thread.
template <class Make>
auto onOneThread(const Make& make) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    return make();
}

} // namespace plumbline::test
