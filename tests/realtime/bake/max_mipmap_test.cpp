// Bounds of blocks of the bilinear surface: sizes, exactness, and that they contain the surface.
#include "realtime/bake/bake.h"
#include "tests/realtime/bake/awkward_maps.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline {
namespace {

using namespace test;

BakedMap pyramidOf(const HeightMap& map) {
    return bakeMap(map, {.kind = "max_mipmap", .scale = {}, .slices = 1});
}

/// The cell of a level that contains cell i of the finest level, computed as in a technique.
int cellAt(int i, int level, int cells) {
    return std::min(i >> level, cells - 1);
}

TEST(MaxMipmap, Levels_HalveToOneCell) {
    const BakedMap pyramid = pyramidOf(noiseMap(13, 4, 1));
    EXPECT_EQ(pyramid.kind, "max_mipmap");
    EXPECT_EQ(pyramid.slices, 1);
    EXPECT_EQ(pyramid.channels, 2);
    const std::vector<std::pair<int, int>> sizes{{13, 4}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(pyramid.levels.size(), sizes.size());
    for (size_t k = 0; k < sizes.size(); ++k)
        EXPECT_EQ(std::pair(pyramid.levels[k].width, pyramid.levels[k].height), sizes[k]);
}

// A row of depths 0 .2 .4 .6 .8: cells between neighbors, where the last one connects to the first under
// repeat and is flat under clamp; the next level has the blocks {0 1} and {2 3 4}, the last level one block.
TEST(MaxMipmap, OneRow_EqualsHandComputed) {
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        const HeightMap row("row", 5, 1, {0.0f, 0.2f, 0.4f, 0.6f, 0.8f}, wrap, wrap);
        const BakedMap pyramid = pyramidOf(row);
        const float closing = wrap == Wrap::Repeat ? 0.0f : 0.8f;
        EXPECT_EQ(pyramid.levels[0].values,
                  (std::vector{0.0f, 0.2f, 0.2f, 0.4f, 0.4f, 0.6f, 0.6f, 0.8f, closing, 0.8f}));
        EXPECT_EQ(pyramid.levels[1].values,
                  (std::vector{0.0f, 0.4f, wrap == Wrap::Repeat ? 0.0f : 0.4f, 0.8f}));
        EXPECT_EQ(pyramid.levels[2].values, (std::vector{0.0f, 0.8f}));
    }
}

TEST(MaxMipmap, Bounds_AreExtremesOfCells) {
    for (const HeightMap& map : awkwardMaps()) {
        SCOPED_TRACE(describe(map));
        const BakedMap pyramid = pyramidOf(map);
        for (int level = 0; level < static_cast<int>(pyramid.levels.size()); ++level) {
            const BakedMap::Level& cells = pyramid.levels[static_cast<size_t>(level)];
            std::vector<float> expected;
            for (int cell = 0; cell < cells.width * cells.height; ++cell)
                expected.insert(expected.end(), {1.0f, 0.0f});
            for (int j = 0; j < map.height(); ++j)
                for (int i = 0; i < map.width(); ++i) {
                    float* bounds = &expected[static_cast<size_t>(
                        2 * (cellAt(j, level, cells.height) * cells.width + cellAt(i, level, cells.width)))];
                    for (const float depth : {map.texel(i, j), map.texel(i + 1, j), map.texel(i, j + 1),
                                              map.texel(i + 1, j + 1)}) {
                        bounds[0] = std::min(bounds[0], depth);
                        bounds[1] = std::max(bounds[1], depth);
                    }
                }
            EXPECT_TRUE(sameBits(cells.values, expected)) << "level " << level;
        }
    }
}

// Also outside [0,1], where a clamped map continues its border, which the nearest cell bounds.
TEST(MaxMipmap, Surface_StaysWithinBounds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-0.5, 1.5);
    for (const HeightMap& map : awkwardMaps()) {
        const BakedMap pyramid = pyramidOf(map);
        const auto cellOf = [](double s, int size, Wrap wrap) {
            const int i = static_cast<int>(std::floor(s * size - 0.5));
            return wrap == Wrap::Repeat ? ((i % size) + size) % size : std::clamp(i, 0, size - 1);
        };
        for (int n = 0; n < 2000; ++n) {
            const Vec2 st(anywhere(random), anywhere(random));
            const int i = cellOf(st.x, map.width(), map.wrapS()), j = cellOf(st.y, map.height(), map.wrapT());
            const double depth = map.depth(st), rounding = 1e-15;
            for (int level = 0; level < static_cast<int>(pyramid.levels.size()); ++level) {
                const BakedMap::Level& cells = pyramid.levels[static_cast<size_t>(level)];
                const float* bounds =
                    pyramid.at(level, 0, cellAt(i, level, cells.width), cellAt(j, level, cells.height));
                ASSERT_GE(depth, bounds[0] - rounding) << describe(map) << ", level " << level;
                ASSERT_LE(depth, bounds[1] + rounding) << describe(map) << ", level " << level;
            }
        }
    }
}

TEST(MaxMipmap, OneThread_GivesEqualBits) {
    const HeightMap map = noiseMap(257, 130, 3);
    const BakedMap many = pyramidOf(map), one = onOneThread([&] { return pyramidOf(map); });
    ASSERT_EQ(many.levels.size(), one.levels.size());
    for (size_t k = 0; k < many.levels.size(); ++k)
        EXPECT_TRUE(sameBits(many.levels[k].values, one.levels[k].values)) << k;
}

} // namespace
} // namespace plumbline
