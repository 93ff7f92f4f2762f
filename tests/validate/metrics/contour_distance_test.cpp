#include "scenes/core/nearest_rank.h"
#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/contour_distance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// Square roots and sums of them in another order have rounding errors in the 16th digit; sums here have
/// fewer than 1000 terms.
constexpr double kRounding = 1e-12;

ContourDistance pooled(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects = {}) {
    const FramePair pair(reference, test, std::move(objects));
    return computeContourDistance(pair, allOf(pair));
}

Frame disc(int size, double radius) {
    Frame frame = emptyFrame(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (std::hypot(x - size / 2, y - size / 2) <= radius) paintPixel(frame, x, y, 1, 2);
    return frame;
}

// The contour of a 4 x 4 square is the square without the inner 2 x 2.
TEST(ContourDistance, IdenticalSquares_AreZero) {
    Frame frame = emptyFrame(10, 10);
    paintRectangle(frame, 3, 2, 7, 6);
    const ContourDistance result = pooled(frame, frame);
    EXPECT_EQ(result.referencePx, 12u);
    EXPECT_EQ(result.testPx, 12u);
    EXPECT_EQ(*result.meanPx, 0);
    EXPECT_EQ(*result.hausdorff95Px, 0);
}

// 20 x 10 moved right by 3. Contour: columns 5 and 24 of ten rows, rows 5 and 14 of 18 further columns: 56
// pixels. Distances to the moved one, columns 8 … 27 of the same rows:
//     left column, 10 pixels: 3 to its left column, from the corners too, whose nearest pixel is at column 8:
//     10 x 3 columns 6 and 7 of the two rows: 2 and 1, twice each: 6 columns 8 … 23 of the two rows: 0 right
//     column: 0 in rows 5 and 14; in rows 6 … 13 the minimum of the distance to the nearer of those rows,
//         1 2 3 4 4 3 2 1, and to the moved right column, 3: 1 2 3 3 3 3 2 1 = 18
// The sum is 54 in each direction by symmetry (rotation by 180 degrees): mean 108 / 112. Rank ceil(0.95 * 56)
// = 54 of 56: 3.
TEST(ContourDistance, RectangleShiftedByThree_HasHandComputedDistance) {
    Frame reference = emptyFrame(40, 20), test = emptyFrame(40, 20);
    paintRectangle(reference, 5, 5, 25, 15);
    paintRectangle(test, 8, 5, 28, 15);
    const ContourDistance result = pooled(reference, test);
    EXPECT_EQ(result.referencePx, 56u);
    EXPECT_EQ(result.testPx, 56u);
    EXPECT_EQ(*result.meanPx, 108.0 / 112.0);
    EXPECT_EQ(*result.hausdorff95Px, 3);
}

// A contour pixel of a disc of radius r is at most r and more than r - 1 from the center, because a neighbor
// is outside. Pixels of the contours of r and r + k are therefore more than k - 1 apart. From a pixel of one
// contour go outwards or inwards: where the nearest pixel centers change from inside the other disc to
// outside, at r + k +- sqrt(2) / 2, there is a pixel of its contour within sqrt(2) / 2: at most k + 1 +
// sqrt(2) away.
TEST(ContourDistance, ConcentricDiscs_AreRadiusDifference) {
    for (const int k : {2, 5, 12}) {
        const ContourDistance result = pooled(disc(81, 20), disc(81, 20 + k));
        EXPECT_GT(*result.meanPx, k - 1);
        EXPECT_GE(*result.hausdorff95Px, *result.meanPx);
        EXPECT_LT(*result.hausdorff95Px, k + 1 + std::sqrt(2));
    }
}

// 3 right and 4 down: 5.
TEST(ContourDistance, OnePixelEach_IsTheirDistance) {
    Frame reference = emptyFrame(9, 9), test = emptyFrame(9, 9);
    paintPixel(reference, 2, 1, 1, 2);
    paintPixel(test, 5, 5, 1, 2);
    const ContourDistance result = pooled(reference, test);
    EXPECT_EQ(result.referencePx, 1u);
    EXPECT_EQ(*result.meanPx, 5);
    EXPECT_EQ(*result.hausdorff95Px, 5);
}

// 39 pixels of a row, compared with the same pixels and one more, 10 below the end. From the first contour
// all distances are 0. From the second there are 39 zeros and a 10; rank ceil(0.95 * 40) = 38: 0. Mean 10
// / 79. With 19 pixels rank ceil(0.95 * 20) = 19 of 20 is still 0; with 18, ceil(18.05) = 19 of 19 is 10. The
// directed percentiles aren't pooled: in the 37 pooled values 10 would be the last, and rank ceil(35.15) = 36
// is 0.
TEST(ContourDistance, Hausdorff_IsLargerDirectedPercentile) {
    for (const auto& [count, expected] : {std::pair(39, 0.0), {19, 0.0}, {18, 10.0}}) {
        Frame reference = emptyFrame(45, 14);
        paintRectangle(reference, 1, 1, 1 + count, 2);
        Frame test = reference;
        paintPixel(test, count, 11, 1, 2);
        const ContourDistance result = pooled(reference, test);
        EXPECT_EQ(result.testPx, result.referencePx + 1);
        EXPECT_EQ(*result.hausdorff95Px, expected) << count;
        EXPECT_EQ(*result.meanPx, 10.0 / (2 * count + 1)) << count;
        EXPECT_EQ(*pooled(test, reference).hausdorff95Px, expected) << count;
    }
}

// Columns 0 … 2 and 0 … 4 of an 8 x 6 image, all rows: the image border has no contour, so each contour is a
// column of 6 pixels, at a distance of 2.
TEST(ContourDistance, ImageBorder_IsNoContour) {
    Frame reference = emptyFrame(8, 6), test = emptyFrame(8, 6);
    paintRectangle(reference, 0, 0, 3, 6);
    paintRectangle(test, 0, 0, 5, 6);
    const ContourDistance result = pooled(reference, test);
    EXPECT_EQ(result.referencePx, 6u);
    EXPECT_EQ(result.testPx, 6u);
    EXPECT_EQ(*result.meanPx, 2);
    EXPECT_EQ(*result.hausdorff95Px, 2);
}

// Diagonal neighbors don't count: in a 3 x 3 square without one corner the center is inside.
TEST(ContourDistance, DiagonalNeighbors_MakeNoContour) {
    Frame frame = emptyFrame(5, 5);
    paintRectangle(frame, 1, 1, 4, 4);
    set(frame, "id", 1, 1, 0);
    EXPECT_EQ(pooled(frame, frame).referencePx, 7u);
}

TEST(ContourDistance, NoContour_IsAbsentWithReason) {
    Frame some = emptyFrame(4, 3), full = emptyFrame(4, 3);
    const Frame nothing = emptyFrame(4, 3);
    paintPixel(some, 1, 1, 1, 2);
    paintRectangle(full, 0, 0, 4, 3);
    const auto reason = [](const Frame& reference, const Frame& test) {
        const ContourDistance result = pooled(reference, test, {objectWithRelief(1, 0.1)});
        EXPECT_FALSE(result.meanPx);
        EXPECT_EQ(result.meanPx, result.hausdorff95Px);
        return result.meanPx.reason();
    };
    EXPECT_THAT(reason(some, nothing), HasSubstr("the test frame shows no contour"));
    EXPECT_THAT(reason(nothing, some), HasSubstr("the reference frame shows no contour"));
    EXPECT_THAT(reason(nothing, nothing), HasSubstr("neither frame shows"));
    EXPECT_THAT(reason(full, full), HasSubstr("or all of them"));
    EXPECT_THAT(reason(full, some), HasSubstr("the reference frame"));
    EXPECT_EQ(pooled(some, nothing).referencePx, 1u);
}

// Two adjacent squares that change places: their union is unchanged, but each has moved by its width.
TEST(ContourDistance, SeveralObjects_PoolTheUnion) {
    Frame reference = emptyFrame(8, 4), test = emptyFrame(8, 4);
    paintRectangle(reference, 2, 1, 4, 3, 1);
    paintRectangle(reference, 4, 1, 6, 3, 2);
    paintRectangle(test, 2, 1, 4, 3, 2);
    paintRectangle(test, 4, 1, 6, 3, 1);
    const FramePair pair(reference, test, {});
    const ContourDistance both = computeContourDistance(pair, allOf(pair));
    EXPECT_EQ(both.referencePx, 8u);
    EXPECT_EQ(*both.meanPx, 0);
    const size_t first = 0;
    const ContourDistance one = computeContourDistance(pair, std::span(&first, 1));
    EXPECT_EQ(one.referencePx, 4u);
    EXPECT_EQ(*one.meanPx, 1.5); // columns 2 3 to 4 5: 2 and 1, and back
    EXPECT_EQ(*one.hausdorff95Px, 2);
}

struct Point {
    int x, y;
};

/// Brute force from the definition.
std::vector<Point> slowContour(const Frame& frame, const std::vector<int>& ids) {
    const auto shown = [&](int x, int y) {
        const float id = frame.channel("id")[static_cast<size_t>(y * frame.width() + x)];
        return std::find(ids.begin(), ids.end(), static_cast<int>(id)) != ids.end();
    };
    std::vector<Point> contour;
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x)
            for (const Point step : {Point{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const int nx = x + step.x, ny = y + step.y;
                const bool inside = nx >= 0 && ny >= 0 && nx < frame.width() && ny < frame.height();
                if (!shown(x, y) || !inside || shown(nx, ny)) continue;
                contour.push_back({x, y});
                break;
            }
    return contour;
}

std::vector<double> slowDistances(const std::vector<Point>& from, const std::vector<Point>& to) {
    std::vector<double> distances;
    for (const Point& a : from) {
        double nearest = kInfinityF;
        for (const Point& b : to)
            nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
        distances.push_back(nearest);
    }
    std::sort(distances.begin(), distances.end());
    return distances;
}

void expectSlowVersions(const Frame& reference, const Frame& test, const ContourDistance& result,
                        const std::vector<int>& ids) {
    const auto a = slowContour(reference, ids), b = slowContour(test, ids);
    RC_ASSERT(result.referencePx == a.size());
    RC_ASSERT(result.testPx == b.size());
    RC_ASSERT(bool(result.meanPx) == (!a.empty() && !b.empty()));
    if (!result.meanPx) return;
    const auto there = slowDistances(a, b), back = slowDistances(b, a);
    const double sum =
        std::accumulate(there.begin(), there.end(), 0.0) + std::accumulate(back.begin(), back.end(), 0.0);
    RC_ASSERT(std::abs(*result.meanPx - sum / static_cast<double>(a.size() + b.size())) < kRounding);
    const double hausdorff =
        std::max(there[nearestRankIndex(there.size(), 95)], back[nearestRankIndex(back.size(), 95)]);
    RC_ASSERT(std::abs(*result.hausdorff95Px - hausdorff) < kRounding);
}

RC_GTEST_PROP(ContourDistanceProperty, DenseMasks_EqualAllPairs, ()) {
    const Frame reference = randomFrame(), test = randomFrame();
    const FramePair pair(reference, test, threeObjects());
    expectSlowVersions(reference, test, computeContourDistance(pair, allOf(pair)), {1, 2, 3});
    const std::vector<size_t> oneAndThree{0, 2};
    expectSlowVersions(reference, test, computeContourDistance(pair, oneAndThree), {1, 3});
    const size_t second = 1;
    expectSlowVersions(reference, test, computeContourDistance(pair, std::span(&second, 1)), {2});
}

/// A few distant rectangles, so that distances are long and most columns empty.
Frame sparseFrame() {
    Frame frame = emptyFrame(48, 37);
    const int count = *rc::gen::inRange(0, 5);
    for (int i = 0; i < count; ++i) {
        const int x = *rc::gen::inRange(0, 48), y = *rc::gen::inRange(0, 37);
        paintRectangle(frame, x, y, std::min(48, x + *rc::gen::inRange(1, 7)),
                       std::min(37, y + *rc::gen::inRange(1, 7)));
    }
    return frame;
}

RC_GTEST_PROP(ContourDistanceProperty, SparseMasks_EqualAllPairs, ()) {
    const Frame reference = sparseFrame(), test = sparseFrame();
    expectSlowVersions(reference, test, pooled(reference, test), {1});
}

RC_GTEST_PROP(ContourDistanceProperty, SwappedFrames_SwapCounts, ()) {
    const Frame a = sparseFrame(), b = sparseFrame();
    const ContourDistance there = pooled(a, b), back = pooled(b, a);
    RC_ASSERT(bool(there.meanPx) == bool(back.meanPx));
    if (there.meanPx) {
        RC_ASSERT(there.meanPx == back.meanPx);
        RC_ASSERT(there.hausdorff95Px == back.hausdorff95Px);
    }
    RC_ASSERT(there.referencePx == back.testPx);
    RC_ASSERT(there.testPx == back.referencePx);
}

RC_GTEST_PROP(ContourDistanceProperty, FlippedFrames_AreEqual, ()) {
    const Frame a = sparseFrame(), b = sparseFrame();
    const ContourDistance result = pooled(a, b);
    for (const auto flipped : {flippedHorizontally, flippedVertically}) {
        const ContourDistance other = pooled(flipped(a), flipped(b));
        RC_ASSERT(bool(other.meanPx) == bool(result.meanPx));
        if (!result.meanPx) continue;
        RC_ASSERT(std::abs(*other.meanPx - *result.meanPx) < kRounding);
        RC_ASSERT(other.hausdorff95Px == result.hausdorff95Px);
    }
}

} // namespace
} // namespace plumbline
