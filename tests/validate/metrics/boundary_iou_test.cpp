#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/boundary_iou.h"
#include "validate/metrics/contour_distance.h"
#include "validate/metrics/silhouette_iou.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

enum Width { k1px, k2px, k4px, k2pct };

BoundaryIou boundaryOf(const FramePair& pair, ObjectSelection selection) {
    return computeBoundaryIou(pair, selection, findBoundaryRims(pair));
}

BoundaryIou pooled(const Frame& reference, const Frame& test) {
    const FramePair pair(reference, test, {});
    return boundaryOf(pair, allOf(pair));
}

TEST(BoundaryIou, IdenticalSquares_AreOne) {
    Frame frame = emptyFrame(20, 20);
    paintRectangle(frame, 4, 4, 14, 14);
    const BoundaryIou result = pooled(frame, frame);
    // 10 x 10 minus 8 x 8, 6 x 6, 2 x 2. The nearest pixel outside is perpendicular to the nearest side.
    EXPECT_EQ(result.at[k1px].unionPx, 36u);
    EXPECT_EQ(result.at[k2px].unionPx, 64u);
    EXPECT_EQ(result.at[k4px].unionPx, 96u);
    EXPECT_EQ(result.at[k2pct].unionPx, 36u); // 2 % of sqrt(800) px is less than one
    for (const auto& at : result.at)
        EXPECT_EQ(*at.iou, 1);
}

// Columns and rows 4 … 13, compared with columns 5 … 14. The rims of 1 px are the contours of the squares, 36
// pixels each. They share columns 5 … 13 of rows 4 and 13, 18 pixels, and no others: column 4 is outside the
// test, 14 outside the reference, and columns 5 and 13 of rows 5 … 12 are in the rim of one only. IoU 18 /
// (36 + 36 - 18) = 1/3.
TEST(BoundaryIou, SquareShiftedByOne_EqualsHandComputed) {
    Frame reference = emptyFrame(20, 20);
    paintRectangle(reference, 4, 4, 14, 14);
    const BoundaryIou result = pooled(reference, shiftedRight(reference));
    EXPECT_EQ(result.at[k1px].intersectionPx, 18u);
    EXPECT_EQ(result.at[k1px].unionPx, 54u);
    EXPECT_EQ(*result.at[k1px].iou, 1.0 / 3.0);
}

// An empty pixel in a 9 x 9 image of the object. The rim of 2 px contains the pixels at a Euclidean distance
// of at most 2 from it: 4 at 1, 4 at sqrt(2), 4 at 2; not the 8 at sqrt(5). Erosion by a square would include
// all 24. The rim of 1 px has 4. The image border is no outline.
TEST(BoundaryIou, Distance_IsEuclidean) {
    Frame frame = emptyFrame(9, 9);
    paintRectangle(frame, 0, 0, 9, 9);
    set(frame, "id", 4, 4, 0);
    const BoundaryIou result = pooled(frame, frame);
    EXPECT_EQ(result.at[k1px].unionPx, 4u);
    EXPECT_EQ(result.at[k2px].unionPx, 12u);
    EXPECT_EQ(result.at[k4px].unionPx, 48u); // x² + y² <= 16: 49 lattice points without the center
}

// 300 x 400: 2 % of the diagonal of 500 is exactly 10 px. Columns 0 … 9 are outside, 10 … 19 the rim.
TEST(BoundaryIou, TwoPercent_IsOfDiagonal) {
    Frame frame = emptyFrame(400, 300);
    paintRectangle(frame, 10, 0, 400, 300);
    EXPECT_EQ(pooled(frame, frame).at[k2pct].unionPx, 10u * 300u);
}

TEST(BoundaryIou, OnePixelMasks_AreDefined) {
    Frame a = emptyFrame(9, 9), b = emptyFrame(9, 9);
    paintPixel(a, 0, 0, 1, 2); // in the corner
    paintPixel(b, 1, 0, 1, 2);
    EXPECT_EQ(*pooled(a, a).at[k1px].iou, 1);
    EXPECT_EQ(*pooled(a, b).at[k4px].iou, 0);
    EXPECT_EQ(pooled(a, b).at[k4px].unionPx, 2u);
}

TEST(BoundaryIou, NoOutline_IsAbsent) {
    const Frame empty = emptyFrame(6, 5);
    Frame full = empty, square = empty;
    paintRectangle(full, 0, 0, 6, 5);
    paintRectangle(square, 1, 1, 4, 4);
    for (const Frame& shown : {full, empty}) {
        const BoundaryIou result = pooled(shown, square);
        EXPECT_EQ(*result.at[k1px].iou, 0); // one of them has an outline
    }
    const FramePair pair(full, full, {objectWithRelief(1, 0.1)}),
        nothing(empty, empty, {objectWithRelief(1, 0.1)});
    for (const FramePair* each : {&pair, &nothing}) {
        const BoundaryIou result = boundaryOf(*each, allOf(*each));
        EXPECT_THAT(result.at[k1px].iou.reason(), HasSubstr("neither frame shows an outline"));
        EXPECT_FALSE(result.at[k1px].range.low);
        EXPECT_EQ(result.at[k2pct].unionPx, 0u);
    }
}

// Objects 1 and 2 are adjacent: the line between them is part of both outlines, also in the pooled figure.
TEST(BoundaryIou, TwoObjects_HaveOwnRims) {
    Frame frame = emptyFrame(8, 4);
    paintRectangle(frame, 0, 0, 4, 4, 1);
    paintRectangle(frame, 4, 0, 8, 4, 2);
    const FramePair pair(frame, frame, {});
    EXPECT_EQ(boundaryOf(pair, allOf(pair)).at[k1px].unionPx, 8u);
}

TEST(BoundaryIou, NoUncertainChannel_HasNoInterval) {
    Frame frame = emptyFrame(6, 6);
    paintRectangle(frame, 2, 2, 4, 4);
    EXPECT_THAT(pooled(frame, frame).at[k1px].range.low.reason(), HasSubstr("no channel uncertain"));
    addUncertainty(frame);
    const BoundaryIou certain = pooled(frame, frame);
    EXPECT_EQ(*certain.at[k1px].range.low, 1);
    EXPECT_EQ(*certain.at[k1px].range.high, 1);
}

/// Brute force from the definition; bits as in BoundaryIou.
std::vector<std::array<bool, 4>> slowRims(const std::vector<int>& ids, int width, int height, int id) {
    const double twoPercent = std::max(1.0, 0.02 * std::hypot(width, height));
    const std::array<double, 4> distances{1, 2, 4, twoPercent};
    std::vector<std::array<bool, 4>> rims(ids.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto pixel = static_cast<size_t>(y * width + x);
            if (ids[pixel] != id) continue;
            double nearest = kInfinityF;
            for (int v = 0; v < height; ++v)
                for (int u = 0; u < width; ++u)
                    if (ids[static_cast<size_t>(v * width + u)] != id)
                        nearest = std::min(nearest, std::hypot(x - u, y - v));
            for (size_t i = 0; i < 4; ++i)
                rims[pixel][i] = nearest <= distances[i];
        }
    return rims;
}

struct SlowSums {
    std::array<uint64_t, 4> intersection{}, whole{};
};

SlowSums slowSums(const std::vector<int>& reference, const std::vector<int>& test, int width, int height,
                  const std::vector<int>& objects) {
    SlowSums sums;
    for (const int id : objects) {
        const auto r = slowRims(reference, width, height, id), t = slowRims(test, width, height, id);
        for (size_t pixel = 0; pixel < r.size(); ++pixel)
            for (size_t i = 0; i < 4; ++i) {
                sums.intersection[i] += r[pixel][i] && t[pixel][i];
                sums.whole[i] += r[pixel][i] || t[pixel][i];
            }
    }
    return sums;
}

std::vector<int> idsOf(const Frame& frame) {
    const auto plane = frame.channel("id");
    return {plane.begin(), plane.end()};
}

void expectSlowVersion(const Frame& a, const Frame& b, const std::vector<size_t>& selection) {
    const FramePair pair(a, b, threeObjects());
    std::vector<int> ids;
    for (const size_t index : selection)
        ids.push_back(pair.objects()[index].id);
    const BoundaryIou result = boundaryOf(pair, selection);
    const SlowSums slow = slowSums(idsOf(a), idsOf(b), a.width(), a.height(), ids);
    for (size_t i = 0; i < 4; ++i) {
        RC_ASSERT(result.at[i].intersectionPx == slow.intersection[i]);
        RC_ASSERT(result.at[i].unionPx == slow.whole[i]);
    }
}

/// Rectangles of three objects, wider than the widest rim.
Frame boxesFrame() {
    Frame frame = emptyFrame(31, 23);
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
        const int x = *rc::gen::inRange(0, 31), y = *rc::gen::inRange(0, 23);
        paintRectangle(frame, x, y, std::min(31, x + *rc::gen::inRange(1, 20)),
                       std::min(23, y + *rc::gen::inRange(1, 20)), *rc::gen::inRange(1, 4));
    }
    return frame;
}

RC_GTEST_PROP(BoundaryIouProperty, RandomFrames_EqualAllPairs, ()) {
    const bool boxes = *rc::gen::arbitrary<bool>();
    const Frame a = boxes ? boxesFrame() : randomFrame(), b = boxes ? boxesFrame() : randomFrame();
    expectSlowVersion(a, b, {0, 1, 2});
    expectSlowVersion(a, b, {1});
}

RC_GTEST_PROP(BoundaryIouProperty, SwappedOrFlipped_IsEqual, ()) {
    const Frame a = boxesFrame(), b = boxesFrame();
    const BoundaryIou result = pooled(a, b);
    for (const BoundaryIou& other : {pooled(b, a), pooled(flippedHorizontally(a), flippedHorizontally(b)),
                                     pooled(flippedVertically(a), flippedVertically(b))})
        for (size_t i = 0; i < 4; ++i) {
            RC_ASSERT(other.at[i].intersectionPx == result.at[i].intersectionPx);
            RC_ASSERT(other.at[i].unionPx == result.at[i].unionPx);
        }
}

// Wider rims contain narrower ones, so the sums increase; the silhouettes contain all of them. The rim of 1
// px is the contour.
RC_GTEST_PROP(BoundaryIouProperty, WiderRim_HasLargerSums, ()) {
    const Frame a = boxesFrame(), b = boxesFrame();
    const FramePair pair(a, b, threeObjects());
    const size_t first = 0;
    const std::span<const size_t> one(&first, 1);
    const BoundaryIou result = boundaryOf(pair, one);
    for (const auto& [narrow, wide] : {std::pair(k1px, k2px), {k2px, k4px}}) {
        RC_ASSERT(result.at[narrow].intersectionPx <= result.at[wide].intersectionPx);
        RC_ASSERT(result.at[narrow].unionPx <= result.at[wide].unionPx);
    }
    RC_ASSERT(result.at[k4px].unionPx <= computeSilhouetteIou(pair, one).unionPx);
    const ContourDistance contour = computeContourDistance(pair, one);
    RC_ASSERT(result.at[k1px].unionPx + result.at[k1px].intersectionPx ==
              contour.referencePx + contour.testPx);
}

/// Visits every true image that up to three uncertain pixels allow: any of the objects or none at each.
std::vector<std::vector<int>> trueImages(const Frame& reference) {
    std::vector<std::vector<int>> images{idsOf(reference)};
    for (size_t pixel = 0; pixel < reference.pixelCount(); ++pixel) {
        if (reference.channel("uncertain")[pixel] == 0) continue;
        std::vector<std::vector<int>> more;
        for (const std::vector<int>& image : images)
            for (int id = 0; id <= 3; ++id) {
                more.push_back(image);
                more.back()[pixel] = id;
            }
        images = std::move(more);
    }
    return images;
}

RC_GTEST_PROP(BoundaryIouProperty, TrueImages_LieInInterval, ()) {
    Frame reference = randomFrame();
    const Frame test = randomFrame();
    addUncertainty(reference);
    for (int i = 0; i < 3; ++i)
        set(reference, "uncertain", *rc::gen::inRange(0, kRandomWidth), *rc::gen::inRange(0, kRandomHeight),
            1);
    const FramePair pair(reference, test, threeObjects());
    for (const std::vector<size_t>& selection : {std::vector<size_t>{0}, {0, 1, 2}}) {
        const BoundaryIou result = boundaryOf(pair, selection);
        std::vector<int> ids;
        for (const size_t index : selection)
            ids.push_back(pair.objects()[index].id);
        for (const std::vector<int>& image : trueImages(reference)) {
            const SlowSums slow = slowSums(image, idsOf(test), kRandomWidth, kRandomHeight, ids);
            for (size_t i = 0; i < 4; ++i) {
                if (!result.at[i].iou || slow.whole[i] == 0) continue;
                const double iou =
                    static_cast<double>(slow.intersection[i]) / static_cast<double>(slow.whole[i]);
                RC_ASSERT(*result.at[i].range.low <= iou);
                RC_ASSERT(iou <= *result.at[i].range.high);
            }
        }
    }
}

} // namespace
} // namespace plumbline
