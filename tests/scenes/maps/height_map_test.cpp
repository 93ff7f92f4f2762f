#include "scenes/maps/height_map.h"
#include "tests/errors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

/// Bottom row 0, 1; top row 0.5, 0.25. Centers at s, t = 0.25 and 0.75.
HeightMap twoByTwo(Wrap wrap = Wrap::Repeat) {
    return HeightMap("map", 2, 2, {0, 1, 0.5f, 0.25f}, wrap, wrap);
}

TEST(HeightMap, TexelCenter_IsExact) {
    const HeightMap map = twoByTwo();
    EXPECT_EQ(map.depth({0.25, 0.25}), 0);
    EXPECT_EQ(map.depth({0.75, 0.25}), 1);
    EXPECT_EQ(map.depth({0.25, 0.75}), 0.5);
    EXPECT_EQ(map.depth({0.75, 0.75}), 0.25);
}

TEST(HeightMap, BetweenCenters_IsBilinear) {
    const HeightMap map = twoByTwo();
    EXPECT_EQ(map.depth({0.5, 0.25}), 0.5);
    EXPECT_EQ(map.depth({0.5, 0.5}), (0 + 1 + 0.5 + 0.25) / 4);
    // Weights 1/4 and 1/2 of a texel: lower 0.25, upper 0.5 - 0.25/4 = 0.4375, their middle 0.34375.
    EXPECT_EQ(map.depth({0.375, 0.5}), 0.34375);
}

TEST(HeightMap, RepeatAcrossSeam_Blends) {
    const HeightMap map = twoByTwo();
    EXPECT_EQ(map.depth({0, 0.25}), 0.5); // halfway between the last texel and the first
    EXPECT_EQ(map.depth({1, 0.25}), 0.5);
    EXPECT_EQ(map.depth({-0.125, 0.25}), 0.75); // 3/4 of texel 1, 1/4 of texel 0
    EXPECT_EQ(map.depth({7.75, -2.75}), 1);
    EXPECT_EQ(map.depth({-1e-30, 0.25}), 0.5); // -1e-30 - floor(-1e-30) rounds to 1
}

TEST(HeightMap, ClampBeyondBorder_HoldsBorder) {
    const HeightMap map = twoByTwo(Wrap::Clamp);
    EXPECT_EQ(map.depth({0, 0.25}), 0);
    EXPECT_EQ(map.depth({-1e300, 0.25}), 0);
    EXPECT_EQ(map.depth({1e300, 0.25}), 1);
    EXPECT_EQ(map.depth({kInfinity, -kInfinity}), 1);
    EXPECT_EQ(map.depth({-kInfinity, kInfinity}), 0.5);
    EXPECT_EQ(map.sample({1.5, 0.25}).gradient, Vec2(0, 0.0 + (0.25 - 1) * 2)); // constant along s outside
}

TEST(HeightMap, MixedWrap_IsPerAxis) {
    const HeightMap map("map", 2, 1, {0, 1}, Wrap::Clamp, Wrap::Repeat);
    EXPECT_EQ(map.depth({1.25, 5}), 1);
    EXPECT_TRUE(std::isnan(map.depth({0.5, kInfinity})));
    EXPECT_EQ(map.depth({kInfinity, 0.5}), 1);
}

TEST(HeightMap, NonFiniteSt_GivesNan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(twoByTwo().depth({nan, 0})));
    EXPECT_TRUE(std::isnan(twoByTwo().depth({0, kInfinity})));
    EXPECT_TRUE(std::isnan(twoByTwo(Wrap::Clamp).sample({nan, 0}).gradient.x));
}

TEST(HeightMap, HugeSt_Repeats) {
    const HeightMap map = twoByTwo();
    // Doubles from 2^52 on are integers, which are equivalent to s = 0.
    EXPECT_EQ(map.depth({std::ldexp(1.0, 60), 0.25}), 0.5);
    EXPECT_EQ(map.depth({-1e300, 0.25}), 0.5);
    EXPECT_EQ(map.depth({std::ldexp(1.0, 40) + 0.25, 0.25}), 0);
}

TEST(HeightMap, InsidePatch_GradientIsBilinears) {
    const HeightMap::Sample sample = twoByTwo().sample({0.5, 0.5});
    // Per texel: s: ((1 - 0) + (0.25 - 0.5)) / 2 = 0.375; t: (0.5 + 0.25 - 0 - 1) / 2 = -0.125; 2 texels a
    // unit.
    EXPECT_EQ(sample.gradient, Vec2(0.75, -0.25));
}

TEST(HeightMap, OnCrease_GradientIsRightUpperPatchs) {
    const HeightMap ramp("ramp", 4, 1, {0, 0.5f, 0.5f, 1}, Wrap::Clamp, Wrap::Clamp);
    EXPECT_EQ(ramp.sample({0.375, 0.5}).gradient, Vec2(0, 0)); // texel 1: flat to its right
    EXPECT_EQ(ramp.sample({0.625, 0.5}).gradient, Vec2(2, 0)); // texel 2: 0.5 a texel, 4 texels
    EXPECT_EQ(ramp.sample({0.375 - 1e-9, 0.5}).gradient, Vec2(2, 0));
    // The double just below the crease at the first texel's center, where the map is clamped and constant.
    EXPECT_EQ(ramp.sample({std::nextafter(0.125, 0.0), 0.5}).gradient, Vec2(0, 0));
}

TEST(HeightMap, Constant_IsSameEverywhere) {
    const HeightMap map = HeightMap::constant("half", 0.3f);
    EXPECT_EQ(map.depth({0.123, 45.6}), static_cast<double>(0.3f));
    EXPECT_EQ(map.sample({-7, 0.5}).gradient, Vec2(0, 0));
}

TEST(HeightMap, TexelOutside_Wraps) {
    const HeightMap map = twoByTwo();
    EXPECT_EQ(map.texel(-1, 0), 1);
    EXPECT_EQ(map.texel(2, 3), 0.5f);
    EXPECT_EQ(map.texel(std::numeric_limits<int>::min(), 0), 0);
    EXPECT_EQ(twoByTwo(Wrap::Clamp).texel(100, -100), 1);
}

TEST(HeightMap, InvalidDepths_AreRefused) {
    EXPECT_EQ(
        inputErrorOf([] {
            HeightMap("m", 2, 2, {0, 1, 1.5f, kNanF});
        }),
        "m: 2 of 4 values are NaN or outside [0,1], the first is 1.5 at column 0, row 1 from the bottom; "
        "expected relief depths or heights in [0,1]");
    EXPECT_EQ(inputErrorOf([] {
                  HeightMap("m", 2, 2, {0, 1, 1});
              }),
              "m: 3 values for a height map of 2 x 2; expected at least 1 x 1 texels and a value for each");
    EXPECT_THROW(HeightMap("m", 0, 0, {}), InputError);
    EXPECT_THROW(HeightMap("m", -1, -1, {0}), InputError);
}

/// The definition: the sum over all texels of a tent function around each center, with three repetitions of
/// the map.
double tentSum(const HeightMap& map, double s, double t) {
    double sum = 0;
    for (int j = -map.height(); j < 2 * map.height(); ++j)
        for (int i = -map.width(); i < 2 * map.width(); ++i) {
            const double x = std::abs(s * map.width() - (i + 0.5)),
                         y = std::abs(t * map.height() - (j + 0.5));
            sum += std::max(0.0, 1 - x) * std::max(0.0, 1 - y) * map.texel(i, j);
        }
    return sum;
}

RC_GTEST_PROP(HeightMapProperty, AnyMap_IsSumOfTents, ()) {
    const int width = *rc::gen::inRange(1, 8), height = *rc::gen::inRange(1, 8);
    std::vector<float> depths(static_cast<size_t>(width * height));
    for (float& d : depths)
        d = static_cast<float>(*rc::gen::inRange(0, 256)) / 255.0f;
    const Wrap wrapS = *rc::gen::element(Wrap::Repeat, Wrap::Clamp),
               wrapT = *rc::gen::element(Wrap::Repeat, Wrap::Clamp);
    const HeightMap map("map", width, height, depths, wrapS, wrapT);
    const Vec2 st(*rc::gen::inRange(-500, 1500) / 1000.0, *rc::gen::inRange(-500, 1500) / 1000.0);
    // Up to 4 products of numbers up to 1, at coordinates of about 10 texels.
    RC_ASSERT(std::abs(map.depth(st) - tentSum(map, st.x, st.y)) < 1e-13);
}

RC_GTEST_PROP(HeightMapProperty, AnyPlace_GradientIsSlope, ()) {
    const int width = *rc::gen::inRange(1, 8), height = *rc::gen::inRange(1, 8);
    std::vector<float> depths(static_cast<size_t>(width * height));
    for (float& d : depths)
        d = static_cast<float>(*rc::gen::inRange(0, 256)) / 255.0f;
    const HeightMap map("map", width, height, depths);
    // Within a patch: between the centers of texels (i, j) and (i + 1, j + 1).
    const Vec2 st((*rc::gen::inRange(-10, 10) + 0.5 + *rc::gen::inRange(10, 90) / 100.0) / width,
                  (*rc::gen::inRange(-10, 10) + 0.5 + *rc::gen::inRange(10, 90) / 100.0) / height);
    const double step = 1e-3; // central differences inside a bilinear patch are exact up to rounding
    const Vec2 slope((map.depth(st + Vec2(step, 0)) - map.depth(st - Vec2(step, 0))) / (2 * step),
                     (map.depth(st + Vec2(0, step)) - map.depth(st - Vec2(0, step))) / (2 * step));
    RC_ASSERT(glm::length(slope - map.sample(st).gradient) < 1e-10);
    RC_ASSERT(map.sample(st).depth == map.depth(st));
}

RC_GTEST_PROP(HeightMapProperty, AnyFloatBits_StayInRange, (double s, double t)) {
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        const double depth = twoByTwo(wrap).depth({s, t});
        const bool place = std::isfinite(s) && std::isfinite(t);
        const bool inRange = depth >= 0 && depth <= 1;
        RC_ASSERT(inRange || (std::isnan(depth) && !place));
    }
}

} // namespace
} // namespace plumbline
