#include "realtime/bake/relief_walk.h"
#include "tests/realtime/bake/cone_test_maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

std::vector<InsideInterval> walk(const HeightMap& map, const DescendingRay& ray, double begin = 0,
                                 double end = 1) {
    std::vector<InsideInterval> intervals;
    walkRelief(map, ray, begin, end, intervals);
    return intervals;
}

/// D = 2 (s - 1/4) from s = 1/4 to 3/4. On s = 0.9 - d/2 that is 1.3 - d: inside from d = 0.65 on, 0.7 deep
/// at d = 1.
TEST(ReliefWalk, Slope_IsEnteredAtExactPlace) {
    const HeightMap map("slope", 2, 1, {0, 1}, Wrap::Clamp, Wrap::Clamp);
    const auto intervals = walk(map, {{0.9, 0.3}, {-0.5, 0}});
    ASSERT_EQ(intervals.size(), 1u);
    EXPECT_NEAR(intervals[0].begin, 0.65, 1e-15);
    EXPECT_EQ(intervals[0].end, 1);
    EXPECT_NEAR(intervals[0].deepest, 0.7, 1e-15);
}

/// A ridge of depth 0.2 at s = 1/2, down to 1 within 1/3: D = 0.2 + 2.4 |x|, x = s - 1/2. On d = 0.5 + x/10
/// the ray enters at x = -0.3/2.5, leaves at x = 0.3/2.3, and passes 0.3 below the ridge.
TEST(ReliefWalk, Ridge_IsEnteredAndLeft) {
    const HeightMap map("ridge", 3, 1, {1, 0.2f, 1}, Wrap::Clamp, Wrap::Clamp);
    const double ridge = 0.2f; // as a float stores it
    const auto intervals = walk(map, {{0.5 - 5, 0.5}, {10, 0}}, 0.4, 0.6);
    ASSERT_EQ(intervals.size(), 1u);
    EXPECT_NEAR(intervals[0].begin, 0.5 - (0.5 - ridge) / (1 + 30 * (1 - ridge)), 1e-12);
    EXPECT_NEAR(intervals[0].end, 0.5 + (0.5 - ridge) / (30 * (1 - ridge) - 1), 1e-12);
    EXPECT_NEAR(intervals[0].deepest, 0.5 - ridge, 1e-12);
}

/// One saddle, D = 1 - 4 x (1 - x) / 2 along its diagonal (x from one texel center to the next): a parabola
/// that a chord at d = 0.75 intersects where x (1 - x) = 1/8, passing 0.25 below it at x = 1/2. The chord
/// must descend, here by 1e-9 over the cell.
TEST(ReliefWalk, Patch_GivesBothRoots) {
    const HeightMap map("saddle", 2, 2, {1, 0, 0, 1}, Wrap::Clamp, Wrap::Clamp);
    const double flat = 1e-9;
    const auto intervals =
        walk(map, {{0.5 - 0.75 * 0.5 / flat, 0.5 - 0.75 * 0.5 / flat}, {0.5 / flat, 0.5 / flat}},
             0.75 - flat / 2, 0.75 + flat / 2);
    ASSERT_EQ(intervals.size(), 1u);
    const double half = std::sqrt(0.125);
    EXPECT_NEAR((intervals[0].begin - 0.75) / flat, -half, 1e-6);
    EXPECT_NEAR((intervals[0].end - 0.75) / flat, half, 1e-6);
    EXPECT_NEAR(intervals[0].deepest, 0.25, 1e-6);
}

TEST(ReliefWalk, RandomRays_AgreeWithDenseSamples) {
    constexpr int kSamples = 2000;
    for (const TestMap& test : smallMaps())
        for (int n = 0; n < 60; ++n) {
            SCOPED_TRACE(test.name + ", ray " + std::to_string(n));
            const auto draw = [&](uint32_t purpose) { return randomAt(9, purpose, n); };
            const double slope = std::exp(6 * draw(2) - 4), turns = draw(3);
            const DescendingRay ray{
                {draw(0), draw(1)},
                n % 10 == 0 ? Vec2(slope, 0) : slope * Vec2(sineOfTurns(turns + 0.25), sineOfTurns(turns))};
            const auto intervals = walk(test.map, ray);
            size_t k = 0;
            std::vector<double> deepest(intervals.size(), 0);
            for (int i = 0; i < kSamples; ++i) {
                const double d = (i + 0.5) / kSamples, below = d - test.map.depth(ray.at(d));
                while (k < intervals.size() && intervals[k].end < d)
                    ++k;
                const bool inside = k < intervals.size() && intervals[k].begin <= d;
                if (std::abs(below) > 1e-12) {
                    ASSERT_EQ(inside, below > 0) << "at depth " << d;
                }
                if (inside) deepest[k] = std::max(deepest[k], below);
            }
            for (size_t j = 0; j < intervals.size(); ++j) {
                ASSERT_LE(deepest[j], intervals[j].deepest + 1e-12);
                ASSERT_LT(intervals[j].begin, intervals[j].end);
                if (j > 0) {
                    ASSERT_GT(intervals[j].begin, intervals[j - 1].end);
                }
                // Between two samples the relief changes by at most its largest gradient: 1 per texel along
                // both axes.
                const double change = 1 + slope * (test.map.width() + test.map.height());
                ASSERT_GE(deepest[j], intervals[j].deepest - change / kSamples);
            }
        }
}

TEST(ReliefWalk, VerticalRay_IsInsideFromSurface) {
    const HeightMap map = smoothMap(16, 16, Wrap::Repeat, Wrap::Repeat);
    const auto intervals = walk(map, {{0.3, 0.7}, {0, 0}});
    ASSERT_EQ(intervals.size(), 1u);
    EXPECT_NEAR(intervals[0].begin, map.depth({0.3, 0.7}), 1e-15);
    EXPECT_NEAR(intervals[0].deepest, 1 - map.depth({0.3, 0.7}), 1e-15);
    EXPECT_TRUE(walk(map, {{0.3, 0.7}, {0, 0}}, 0, 0.01).empty());
}

} // namespace
} // namespace plumbline
