#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/fetch_cost.h"
#include "validate/metrics/normal_angle.h"
#include "validate/metrics/search_iterations.h"
#include "validate/metrics/st_error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

NormalAngle normals(const Frame& reference, const Frame& test) {
    const FramePair pair(reference, test, {});
    return computeNormalAngle(pair, allOf(pair));
}

StError coordinates(const Frame& reference, const Frame& test, ObjectInfo object = objectWithRelief(1, 0.1)) {
    const FramePair pair(reference, test, {std::move(object)});
    return computeStError(pair, allOf(pair));
}

Frame covered(int width) {
    Frame frame = emptyFrame(width, 1);
    paintRectangle(frame, 0, 0, width, 1);
    return frame;
}

void setNormal(Frame& frame, int x, float nx, float ny, float nz) {
    set(frame, "N.X", x, 0, nx);
    set(frame, "N.Y", x, 0, ny);
    set(frame, "N.Z", x, 0, nz);
}

// Angles to +z: 0 for the same direction with twice the length, 90 for +x, 180 for -z, 45 for (0, 1, 1). Mean
// 315/4.
TEST(NormalAngle, FourDirections_EqualHandComputed) {
    const Frame reference = covered(4);
    Frame test = covered(4);
    setNormal(test, 0, 0, 0, 2);
    setNormal(test, 1, 1, 0, 0);
    setNormal(test, 2, 0, 0, -1);
    setNormal(test, 3, 0, 1, 1);
    const NormalAngle result = normals(reference, test);
    EXPECT_EQ(result.domainPx, 4u);
    EXPECT_NEAR(*result.meanDegrees, 315.0 / 4, 1e-13); // rounding of atan2 and of the mean
    EXPECT_NEAR(*result.p95Degrees, 180, 1e-13);
}

// The tangent of the angle is 1e-6; acos(1 - 5e-13) would have no correct digits.
TEST(NormalAngle, SmallAngles_KeepDigits) {
    const Frame reference = covered(1);
    Frame test = covered(1);
    setNormal(test, 0, 1e-6f, 0, 1);
    EXPECT_NEAR(*normals(reference, test).meanDegrees, degrees(static_cast<double>(1e-6f)), 1e-15);
}

TEST(NormalAngle, UnusableNormals_AreCountedSeparately) {
    const Frame reference = covered(3);
    Frame test = covered(3);
    setNormal(test, 0, 0, 0, 0);
    setNormal(test, 1, kNanF, 0, 1);
    const NormalAngle some = normals(reference, test);
    EXPECT_EQ(some.domainPx, 1u);
    EXPECT_EQ(some.invalidPx, 2u);
    setNormal(test, 2, kInfinityF, 0, 0);
    EXPECT_THAT(normals(reference, test).meanDegrees.reason(), HasSubstr("no shared pixel"));
    EXPECT_THAT(normals(emptyFrame(3, 1), test).p95Degrees.reason(), HasSubstr("same object"));
    Frame without(3, 1);
    without.add("id")[0] = 1;
    EXPECT_EQ(normals(reference, without).meanDegrees.reason(), "the test frame has no channel N.X");
}

RC_GTEST_PROP(NormalAngleProperty, SwappedIsEqual_IdenticalIsZero, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    RC_ASSERT(normals(a, b).meanDegrees == normals(b, a).meanDegrees);
    if (const Figure self = normals(a, a).p95Degrees) RC_ASSERT(*self == 0.0);
}

// The map has 100 x 50 texels: 0.03 in s is 3 texels, 0.08 in t is 4; together hypot = 5.
TEST(StError, ThreeFourFive_IsFiveTexels) {
    const Frame reference = covered(1);
    Frame test = covered(1);
    set(test, "st.S", 0, 0, 0.53f);
    set(test, "st.T", 0, 0, 0.42f);
    const StError result = coordinates(reference, test);
    EXPECT_EQ(result.domainPx, 1u);
    EXPECT_NEAR(*result.meanTexels, 5, 5e-6); // 0.53f and 0.42f have errors of up to 3e-8, times 100 texels
}

TEST(StError, RepeatSeam_IsNoError) {
    Frame reference = covered(1), test = covered(1);
    set(reference, "st.S", 0, 0, 7.75f);
    set(test, "st.S", 0, 0, 0.25f); // 7.5 tiles away, which is half a tile
    EXPECT_EQ(*coordinates(reference, test).meanTexels, 50);
    set(test, "st.S", 0, 0, -0.25f); // 8 tiles away: the same texel
    EXPECT_EQ(*coordinates(reference, test).meanTexels, 0);
    ObjectInfo clamped = objectWithRelief(1, 0.1);
    clamped.map->repeatS = false;
    EXPECT_EQ(*coordinates(reference, test, clamped).meanTexels, 800);
}

TEST(StError, NoSt_IsAbsentWithReason) {
    const Frame frame = covered(2);
    ObjectInfo unknown = objectWithRelief(1, 0.1);
    unknown.map.reset();
    EXPECT_THAT(coordinates(frame, frame, unknown).meanTexels.reason(), HasSubstr("map size"));
    unknown.reliefDepth = 0;
    EXPECT_THAT(coordinates(frame, frame, unknown).meanTexels.reason(), HasSubstr("no relief"));
    Frame spoiled = frame;
    set(spoiled, "st.S", 0, 0, kNanF);
    set(spoiled, "st.T", 1, 0, kInfinityF);
    const StError none = coordinates(frame, spoiled);
    EXPECT_EQ(none.invalidPx, 2u);
    EXPECT_THAT(none.p95Texels.reason(), HasSubstr("finite"));
}

RC_GTEST_PROP(StErrorProperty, Repeating_IsSymmetricAndBounded, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const FramePair there(a, b, threeObjects()), back(b, a, threeObjects());
    const StError result = computeStError(there, allOf(there));
    RC_ASSERT(result.meanTexels == computeStError(back, allOf(back)).meanTexels);
    if (result.p95Texels) RC_ASSERT(*result.p95Texels <= std::hypot(50.0, 25.0));
}

// Costs 10 … 10, 20 on ten covered pixels. The lookups of a missed pixel don't count.
TEST(FetchCost, CoveredPixels_GiveMeanAndPercentile) {
    const Frame reference = emptyFrame(11, 1);
    Frame test = emptyFrame(11, 1);
    paintRectangle(test, 0, 0, 10, 1);
    const auto fetches = test.add("cost.fetches");
    std::fill(fetches.begin(), fetches.end(), 10.0f);
    fetches[9] = 20;
    fetches[10] = 1000;
    const FramePair pair(reference, test, {});
    const FetchCost result = computeFetchCost(pair, allOf(pair));
    EXPECT_EQ(result.domainPx, 10u);
    EXPECT_DOUBLE_EQ(*result.mean, 11);
    EXPECT_EQ(*result.p99, 20);
}

// Ten covered pixels have 3 lookups in the height map and 2 in a baked one; the last has 13 and 12.
TEST(FetchCost, MapKinds_AreSeparate) {
    const Frame reference = emptyFrame(11, 1);
    Frame test = emptyFrame(11, 1);
    paintRectangle(test, 0, 0, 10, 1);
    const auto height = test.add("cost.fetches.height"), baked = test.add("cost.fetches.baked");
    std::fill(height.begin(), height.end(), 3.0f);
    std::fill(baked.begin(), baked.end(), 2.0f);
    height[9] = 13, baked[9] = 12;
    const FramePair pair(reference, test, {});
    const FetchCost result = computeFetchCost(pair, allOf(pair));
    EXPECT_DOUBLE_EQ(*result.heightMean, 4);
    EXPECT_DOUBLE_EQ(*result.bakedMean, 3);
    EXPECT_THAT(result.mean.reason(), HasSubstr("no channel cost.fetches"));
}

// Iterations 0 1 1 4 on four covered pixels, 99 on a missed one.
TEST(SearchIterations, CoveredPixels_GiveMeanAndHistogram) {
    const Frame reference = emptyFrame(5, 1);
    Frame test = emptyFrame(5, 1);
    paintRectangle(test, 0, 0, 4, 1);
    const auto iterations = test.add("cost.iterations");
    iterations[1] = iterations[2] = 1;
    iterations[3] = 4;
    iterations[4] = 99;
    const FramePair pair(reference, test, {});
    const SearchIterations result = computeSearchIterations(pair, allOf(pair));
    EXPECT_EQ(result.domainPx, 4u);
    EXPECT_DOUBLE_EQ(*result.mean, 1.5);
    EXPECT_EQ(*result.p99, 4);
    EXPECT_EQ(*result.max, 4);
    EXPECT_EQ(result.histogram, (std::vector<uint64_t>{1, 2, 0, 0, 1}));
}

TEST(SearchIterations, LastBin_IsOpen) {
    const Frame reference = emptyFrame(3, 1);
    Frame test = emptyFrame(3, 1);
    paintRectangle(test, 0, 0, 3, 1);
    const auto iterations = test.add("cost.iterations");
    iterations[0] = 63, iterations[1] = 64, iterations[2] = 4000;
    const FramePair pair(reference, test, {});
    const SearchIterations result = computeSearchIterations(pair, allOf(pair));
    ASSERT_EQ(result.histogram.size(), SearchIterations::kHistogramEnd + 1);
    EXPECT_EQ(result.histogram[63], 1u);
    EXPECT_EQ(result.histogram[64], 2u);
    EXPECT_EQ(*result.max, 4000);
}

TEST(SearchIterations, NoChannel_IsAbsentWithReason) {
    const Frame frame = covered(2);
    const FramePair pair(frame, frame, {});
    EXPECT_THAT(computeSearchIterations(pair, allOf(pair)).mean.reason(),
                HasSubstr("no channel cost.iterations"));
    EXPECT_TRUE(computeSearchIterations(pair, allOf(pair)).histogram.empty());
    Frame nothing = emptyFrame(2, 1);
    nothing.add("cost.iterations");
    const FramePair missed(frame, nothing, {});
    EXPECT_THAT(computeSearchIterations(missed, allOf(missed)).max.reason(), HasSubstr("covers no pixel"));
}

TEST(FetchCost, NoChannel_IsAbsentWithReason) {
    const Frame frame = covered(2);
    const FramePair pair(frame, frame, {});
    EXPECT_THAT(computeFetchCost(pair, allOf(pair)).mean.reason(), HasSubstr("cost.fetches"));
    Frame nothing = emptyFrame(2, 1);
    nothing.add("cost.fetches");
    const FramePair missed(frame, nothing, {});
    EXPECT_THAT(computeFetchCost(missed, allOf(missed)).mean.reason(), HasSubstr("covers no pixel"));
}

} // namespace
} // namespace plumbline
