// Compares the bound on a height map's deviation from a plane with results derived by hand and with dense
// samples.
#include "reference/tessellate/map_deviation.h"

#include <gtest/gtest.h>

#include <random>

namespace plumbline {
namespace {

MapPoint on(const HeightMap& map, const Vec2& texel) {
    const Vec2 st = (texel + 0.5) / Vec2(map.width(), map.height());
    return {texel, map.depth(st)};
}

// One bilinear patch with corners 0 0 / 0 1: d = x y. Over the triangle (0,0) (1,0) (0,1) the plane is 0 and
// d is largest at the middle of the diagonal: 1/4. Over the cell's other half the plane is x + y - 1 and d -
// that = (1-x)(1-y): 1/4 too.
TEST(MapDeviation, Saddle_DeviatesByQuarter) {
    const HeightMap map("saddle", 2, 2, {0, 0, 0, 1}, Wrap::Clamp, Wrap::Clamp);
    EXPECT_NEAR(triangleDeviation(map, {on(map, {0, 0}), on(map, {1, 0}), on(map, {0, 1})}), 0.25, 1e-12);
    EXPECT_NEAR(cellDeviation(map, on(map, {0, 0}), on(map, {1, 0}), on(map, {0, 1}), on(map, {1, 1})), 0.25,
                1e-12);
    // A cell half as wide deviates by a quarter of that.
    EXPECT_NEAR(
        cellDeviation(map, on(map, {0, 0}), on(map, {0.5, 0}), on(map, {0, 0.5}), on(map, {0.5, 0.5})),
        1.0 / 16, 1e-12);
}

// A needle: one texel of depth 0 in a map of depth 1. The depth at all corners is 1; the needle's tip
// deviates by 1.
TEST(MapDeviation, NeedleBetweenCorners_IsSeen) {
    std::vector<float> depths(64, 1.0f);
    depths[3 * 8 + 4] = 0;
    const HeightMap map("needle", 8, 8, depths, Wrap::Clamp, Wrap::Clamp);
    EXPECT_NEAR(triangleDeviation(map, {on(map, {0, 0}), on(map, {7, 0}), on(map, {6, 7})}), 1, 1e-12);
    // But not for a triangle that doesn't contain it.
    EXPECT_NEAR(triangleDeviation(map, {on(map, {0, 0}), on(map, {2, 0}), on(map, {0, 7})}), 0, 1e-12);
}

TEST(MapDeviation, Bound_IsTight) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    double tightest = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<float> depths(48);
        for (float& depth : depths)
            depth = static_cast<float>(unit(random));
        const Wrap wrap = trial % 2 ? Wrap::Repeat : Wrap::Clamp;
        const HeightMap map("random", 8, 6, depths, wrap, wrap);
        const double size = std::pow(2.0, 4 * unit(random) - 2);
        const Vec2 origin(20 * unit(random) - 10, 20 * unit(random) - 10);
        std::array<MapPoint, 3> corners;
        for (MapPoint& corner : corners)
            corner = on(map, origin + size * Vec2(unit(random), unit(random)));
        const double bound = triangleDeviation(map, corners);
        double worst = 0;
        for (int i = 0; i <= 60; ++i)
            for (int j = 0; i + j <= 60; ++j) {
                const double b = i / 60.0, c = j / 60.0;
                const Vec2 at = (1 - b - c) * corners[0].texel + b * corners[1].texel + c * corners[2].texel;
                const double plane =
                    (1 - b - c) * corners[0].depth + b * corners[1].depth + c * corners[2].depth;
                worst = std::max(worst, std::abs(on(map, at).depth - plane));
            }
        EXPECT_LE(worst, bound + 1e-9) << "trial " << trial;
        EXPECT_LE(bound, 2 * worst + 1e-9)
            << "trial " << trial; // samples miss the maximum; the deviation counts at most twice
        if (worst > 0) tightest = std::max(tightest, worst / bound);
    }
    EXPECT_GT(tightest, 0.99);
}

TEST(MapDeviation, EnoughThreshold_HidesNoLargerDeviation) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    int hidden = 0, exact = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<float> depths(48);
        for (float& depth : depths)
            depth = static_cast<float>(0.5 + 0.5 * unit(random) * (trial % 2 ? 0.1 : 1));
        const HeightMap map("random", 8, 6, depths);
        const Vec2 origin(20 * unit(random) - 10, 20 * unit(random) - 10);
        const Vec2 u(1.2 * unit(random), 0.3 * unit(random)), v(-0.3 * unit(random), 1.2 * unit(random));
        const MapPoint a = on(map, origin), b = on(map, origin + u), c = on(map, origin + v),
                       d = on(map, origin + u + v);
        const double whole = cellDeviation(map, a, b, c, d), enough = 0.2 * unit(random);
        const double cut = cellDeviation(map, a, b, c, d, enough);
        EXPECT_EQ(std::max(cut, enough), std::max(whole, enough)) << "trial " << trial;
        (cut == whole ? exact : hidden) += 1;
    }
    EXPECT_GT(hidden, 100);
    EXPECT_GT(exact, 100);
}

} // namespace
} // namespace plumbline
