// Maps and rays shared by the tests of the searches.
#pragma once

#include "scenes/maps/generate_map.h"
#include "tests/realtime/draw/trace_glsl.h"
#include "tests/realtime/gl_fixture.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace plumbline {

// Rounding of a float near 1.
inline constexpr double kFloatEpsilon = 0x1p-23;

inline const std::vector<std::string> kSearches{"linear",        "binary",        "linear_secant1",
                                                "linear_binary", "linear_secant", "exact_cells"};
inline const std::vector<std::string> kParallax{"parallax", "parallax_offset_limited", "parallax_slope",
                                                "parallax_slope_exact", "parallax_iterative"};

inline HeightMap profile(std::vector<float> depths, Wrap wrap = Wrap::Repeat) {
    const auto width = static_cast<int>(depths.size());
    return {"profile", width, 1, std::move(depths), wrap, wrap};
}

/// `size` texels of depth 1, except for the ranges `ridges` of depth 0.
inline HeightMap ridge(int size, std::vector<std::pair<int, int>> ridges) {
    std::vector<float> depths(static_cast<size_t>(size), 1);
    for (const auto& [begin, end] : ridges)
        std::fill(depths.begin() + begin, depths.begin() + end, 0.0f);
    return profile(std::move(depths));
}

inline HeightMap randomMap(int width, int height, Wrap wrapS, Wrap wrapT) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> depth(0, 1);
    std::vector<float> depths(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (float& d : depths)
        d = depth(random);
    return {"random", width, height, std::move(depths), wrapS, wrapT};
}

inline HeightMap generated(const std::string& kind, int size) {
    return generateMap(kind, size, 3, Wrap::Repeat, Wrap::Repeat);
}

/// Rays with random origins and directions that cross `travel` tiles of the map.
inline std::vector<ReliefLine> raysOfLength(float travel, size_t count, float low = 0, float high = 1) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> anywhere(low, high), angle(0, 6.2831853f);
    std::vector<ReliefLine> lines;
    for (size_t i = 0; i < count; ++i) {
        const float direction = angle(random);
        lines.push_back({{anywhere(random), anywhere(random)},
                         {travel * std::cos(direction), travel * std::sin(direction)}});
    }
    return lines;
}

inline TracedHit traceOne(const std::string& technique, const HeightMap& map, const ReliefLine& line,
                          const ReliefPath& path = {}) {
    return traceGlsl(technique, map, {line}, path).front();
}

} // namespace plumbline
