#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/depth_error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

DepthError pooled(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects) {
    const FramePair pair(reference, test, std::move(objects));
    return computeDepthError(pair, allOf(pair), reference.channel("Z"), test.channel("Z"));
}

// Four pixels at depth 2 with the errors +1/4, -1/4, +1/2, 0; relief depth 1:
//   bias = 0.5/4 = 0.125     MAE = 1/4 = 0.25     RMSE = sqrt((1/16 + 1/16 + 1/4)/4) = sqrt(3/32)
//   |e| sorted: 0 1/4 1/4 1/2, so p50 = 1/4 (rank 2), p95 = p99 = max = 1/2 (rank 4)
//   above 1 % and 5 %: three pixels; above 25 %: only 1/2, as 1/4 itself is not above.
TEST(DepthError, FourPixels_EqualHandComputed) {
    Frame reference = emptyFrame(4, 1), test = emptyFrame(4, 1);
    paintRectangle(reference, 0, 0, 4, 1, 1, 2.0f);
    const float depths[] = {2.25f, 1.75f, 2.5f, 2.0f};
    for (int x = 0; x < 4; ++x)
        paintPixel(test, x, 0, 1, depths[x]);

    const DepthError result = pooled(reference, test, {objectWithRelief(1, 1.0)});
    EXPECT_EQ(result.domainPx, 4u);
    EXPECT_EQ(*result.world.bias, 0.125);
    EXPECT_EQ(*result.world.mae, 0.25);
    EXPECT_DOUBLE_EQ(*result.world.rmse, std::sqrt(3.0 / 32.0));
    EXPECT_EQ(*result.world.p50, 0.25);
    EXPECT_EQ(*result.world.p95, 0.5);
    EXPECT_EQ(*result.world.p99, 0.5);
    EXPECT_EQ(*result.world.max, 0.5);
    EXPECT_EQ(result.bad1pctPx, 3u);
    EXPECT_EQ(result.bad5pctPx, 3u);
    EXPECT_EQ(result.bad25pctPx, 1u);
    EXPECT_EQ(*result.badpix25pct, 0.25);
}

// The same error of 1/4 on two objects whose reliefs are 1/2 and 1 deep: 0.5 and 0.25 of the relief.
TEST(DepthError, RelativeFigures_UsePixelsObject) {
    Frame reference = emptyFrame(2, 1), test = emptyFrame(2, 1);
    for (int x = 0; x < 2; ++x) {
        paintPixel(reference, x, 0, x + 1, 2.0f);
        paintPixel(test, x, 0, x + 1, 2.25f);
    }
    const DepthError result = pooled(reference, test, {objectWithRelief(1, 0.5), objectWithRelief(2, 1.0)});
    EXPECT_EQ(*result.relief.bias, 0.375);
    EXPECT_EQ(*result.relief.max, 0.5);
    EXPECT_DOUBLE_EQ(*result.relief.rmse, std::sqrt((0.25 + 0.0625) / 2));
    EXPECT_EQ(result.bad25pctPx, 1u); // 0.5 > 0.25, and 0.25 is not
}

TEST(DepthError, PixelsOfOneFrame_AreCounted) {
    Frame reference = emptyFrame(6, 1), test = emptyFrame(6, 1);
    paintRectangle(reference, 0, 0, 3, 1); // columns 0 1 2
    paintRectangle(test, 2, 0, 6, 1);      // columns 2 3 4 5
    const DepthError result = pooled(reference, test, {objectWithRelief(1, 0.1)});
    EXPECT_EQ(result.domainPx, 1u);
    EXPECT_EQ(result.onlyReferencePx, 2u);
    EXPECT_EQ(result.onlyTestPx, 3u);
}

TEST(DepthError, DifferentObjects_AreNotCompared) {
    Frame reference = emptyFrame(1, 1), test = emptyFrame(1, 1);
    paintPixel(reference, 0, 0, 1, 2);
    paintPixel(test, 0, 0, 2, 3);
    const DepthError result = pooled(reference, test, {objectWithRelief(1, 0.1), objectWithRelief(2, 0.1)});
    EXPECT_EQ(result.domainPx, 0u);
    EXPECT_FALSE(result.world.max);
    EXPECT_THAT(result.world.max.reason(), HasSubstr("same object"));
}

TEST(DepthError, NonFiniteDepths_AreCountedSeparately) {
    Frame reference = emptyFrame(4, 1), test = emptyFrame(4, 1);
    paintRectangle(reference, 0, 0, 4, 1);
    paintRectangle(test, 0, 0, 4, 1);
    set(test, "Z", 0, 0, kNanF);
    set(test, "Z", 1, 0, kInfinityF);
    set(reference, "Z", 2, 0, -kInfinityF);
    const DepthError result = pooled(reference, test, {objectWithRelief(1, 0.1)});
    EXPECT_EQ(result.domainPx, 1u);
    EXPECT_EQ(result.invalidPx, 3u);
    EXPECT_EQ(*result.world.max, 0.0);

    for (int x = 0; x < 4; ++x)
        set(test, "Z", x, 0, kNanF);
    const DepthError none = pooled(reference, test, {objectWithRelief(1, 0.1)});
    EXPECT_EQ(none.domainPx, 0u);
    EXPECT_THAT(none.world.rmse.reason(), HasSubstr("finite"));
    EXPECT_FALSE(none.badpix5pct);
}

TEST(DepthError, LargestFloats_StayFinite) {
    Frame reference = emptyFrame(1, 1), test = emptyFrame(1, 1);
    paintPixel(reference, 0, 0, 1, -3e38f);
    paintPixel(test, 0, 0, 1, 3e38f);
    EXPECT_NEAR(*pooled(reference, test, {objectWithRelief(1, 0.1)}).world.rmse, 6e38, 1e33);
}

TEST(DepthError, NoReliefDepth_GivesWorldFiguresOnly) {
    Frame frame = emptyFrame(2, 2);
    paintRectangle(frame, 0, 0, 2, 2);
    const DepthError none = pooled(frame, frame, {objectWithRelief(1, 0)});
    EXPECT_EQ(*none.world.rmse, 0.0);
    EXPECT_FALSE(none.relief.rmse);
    EXPECT_THAT(none.relief.rmse.reason(), HasSubstr("has no relief"));
    const DepthError unknown = pooled(frame, frame, {});
    EXPECT_EQ(*unknown.world.rmse, 0.0);
    EXPECT_THAT(unknown.badpix1pct.reason(), HasSubstr("not known"));
}

TEST(DepthError, NothingCovered_IsAbsent) {
    const Frame nothing = emptyFrame(3, 3);
    const DepthError result = pooled(nothing, nothing, {objectWithRelief(1, 0.1)});
    EXPECT_EQ(result.domainPx, 0u);
    for (const Figure& figure : {result.world.bias, result.world.rmse, result.world.p50, result.world.max,
                                 result.relief.rmse, result.badpix1pct, result.badpix25pct})
        EXPECT_FALSE(figure);
}

TEST(DepthError, NoDepthChannel_IsAbsentWithReason) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    const FramePair pair(frame, frame, {objectWithRelief(1, 0.1)});
    const DepthError result = computeDepthError(pair, allOf(pair), frame.channel("Z"), {}, "no depth today");
    EXPECT_EQ(result.world.mae.reason(), "no depth today");
    EXPECT_EQ(result.relief.mae.reason(), "no depth today");
    EXPECT_EQ(result.domainPx, 0u);
}

/// Brute force: the percentile by counting, sums in long double.
double percentileByCounting(const std::vector<double>& values, double percent) {
    double best = kInfinity;
    for (const double candidate : values) {
        const auto within =
            std::count_if(values.begin(), values.end(), [&](double v) { return v <= candidate; });
        if (static_cast<double>(within) * 100.0 >= percent * static_cast<double>(values.size()))
            best = std::min(best, candidate);
    }
    return best;
}

RC_GTEST_PROP(DepthErrorProperty, RandomFrames_EqualPlainVersion, ()) {
    const Frame reference = randomFrame(), test = randomFrame();
    const auto objects = threeObjects();
    std::vector<double> magnitudes;
    long double sum = 0, squares = 0;
    uint64_t invalid = 0, bad = 0;
    for (size_t i = 0; i < reference.pixelCount(); ++i) {
        const float id = reference.channel("id")[i];
        if (id == 0 || id != test.channel("id")[i]) continue;
        const double error = double(test.channel("Z")[i]) - double(reference.channel("Z")[i]);
        if (!std::isfinite(error)) {
            ++invalid;
            continue;
        }
        const double depth = *objects[static_cast<size_t>(id) - 1].reliefDepth;
        magnitudes.push_back(std::abs(error));
        sum += error;
        squares += error * error;
        bad += std::abs(error) / depth > 0.25;
    }
    const DepthError result = pooled(reference, test, objects);
    RC_ASSERT(result.domainPx == magnitudes.size());
    RC_ASSERT(result.invalidPx == invalid);
    RC_ASSERT(result.bad25pctPx == bad);
    if (magnitudes.empty()) return;
    const auto count = static_cast<long double>(magnitudes.size());
    // Errors are multiples of 1/64 below 4: every sum is exact in double, so equality is the right test.
    RC_ASSERT(*result.world.bias == static_cast<double>(sum) / static_cast<double>(count));
    RC_ASSERT(*result.world.rmse == std::sqrt(static_cast<double>(squares) / static_cast<double>(count)));
    RC_ASSERT(*result.world.p50 == percentileByCounting(magnitudes, 50));
    RC_ASSERT(*result.world.p95 == percentileByCounting(magnitudes, 95));
    RC_ASSERT(*result.world.p99 == percentileByCounting(magnitudes, 99));
    RC_ASSERT(*result.world.max == percentileByCounting(magnitudes, 100));
}

RC_GTEST_PROP(DepthErrorProperty, SwappedFrames_NegateBiasOnly, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const DepthError there = pooled(a, b, threeObjects()), back = pooled(b, a, threeObjects());
    RC_ASSERT(there.domainPx == back.domainPx);
    RC_ASSERT(there.onlyReferencePx == back.onlyTestPx);
    RC_ASSERT(there.world.rmse == back.world.rmse);
    RC_ASSERT(there.world.p95 == back.world.p95);
    if (there.world.bias) RC_ASSERT(*there.world.bias == -*back.world.bias);
}

RC_GTEST_PROP(DepthErrorProperty, IdentityAndFlips_KeepZero, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const DepthError self = pooled(a, a, threeObjects());
    if (self.world.max) RC_ASSERT(*self.world.max == 0.0);
    const DepthError plain = pooled(a, b, threeObjects());
    const DepthError flipped = pooled(flippedVertically(a), flippedVertically(b), threeObjects());
    RC_ASSERT(plain.world.rmse == flipped.world.rmse);
    RC_ASSERT(plain.world.p50 == flipped.world.p50);
}

} // namespace
} // namespace plumbline
