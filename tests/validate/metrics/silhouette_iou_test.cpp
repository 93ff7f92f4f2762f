#include "scenes/core/error.h"
#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/silhouette_iou.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>
#include <set>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

SilhouetteIou pooled(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects = {}) {
    const FramePair pair(reference, test, std::move(objects));
    return computeSilhouetteIou(pair, allOf(pair));
}

TEST(SilhouetteIou, IdenticalSquares_AreOne) {
    Frame frame = emptyFrame(10, 10);
    paintRectangle(frame, 3, 2, 7, 6); // 4 x 4
    const SilhouetteIou result = pooled(frame, frame);
    EXPECT_EQ(*result.iou, 1.0);
    EXPECT_EQ(result.referencePx, 16u);
    EXPECT_EQ(result.testPx, 16u);
    EXPECT_EQ(result.intersectionPx, 16u);
    EXPECT_EQ(result.unionPx, 16u);
    EXPECT_EQ(result.missingPx, 0u);
    EXPECT_EQ(result.extraPx, 0u);
}

// A 4 x 4 square moved by one pixel: 3 columns of 4 are shared, one column is missing, one is extra: 12 / (12
// + 4 + 4).
TEST(SilhouetteIou, SquareShiftedByOne_EqualsHandComputed) {
    Frame frame = emptyFrame(10, 10);
    paintRectangle(frame, 3, 2, 7, 6);
    const SilhouetteIou result = pooled(frame, shiftedRight(frame));
    EXPECT_EQ(*result.iou, 12.0 / 20.0);
    EXPECT_EQ(result.missingPx, 4u);
    EXPECT_EQ(result.extraPx, 4u);
}

// Of a square of 4 x 4, columns 4 to 6 show the back; the test lacks the first two columns.
TEST(SilhouetteIou, BackSides_AreCountedApart) {
    Frame reference = emptyFrame(10, 10), test = emptyFrame(10, 10);
    paintRectangle(reference, 3, 2, 7, 6);
    paintRectangle(test, 5, 2, 7, 6);
    SilhouetteIou result = pooled(reference, test);
    EXPECT_THAT(result.backPx.reason(), HasSubstr("the reference frame has no channel facing"));
    reference.add("facing");
    for (int y = 2; y < 6; ++y)
        for (int x = 3; x < 7; ++x)
            set(reference, "facing", x, y, x >= 4 ? -1.0f : 1.0f);
    result = pooled(reference, test);
    EXPECT_EQ(*result.backPx, 12);
    EXPECT_EQ(result.missingPx, 8u);
    EXPECT_EQ(*result.missingBackPx, 4);
}

TEST(SilhouetteIou, NeighboringPixels_AreZero) {
    Frame left = emptyFrame(2, 1), right = emptyFrame(2, 1);
    paintPixel(left, 0, 0, 1, 2);
    paintPixel(right, 1, 0, 1, 2);
    const SilhouetteIou result = pooled(left, right);
    EXPECT_EQ(*result.iou, 0.0); // 0 of 2: zero, not absent
    EXPECT_EQ(result.unionPx, 2u);
}

TEST(SilhouetteIou, OnePixelFrames_AreDefined) {
    Frame covered = emptyFrame(1, 1);
    paintPixel(covered, 0, 0, 1, 2);
    EXPECT_EQ(*pooled(covered, covered).iou, 1.0);
    EXPECT_EQ(*pooled(covered, emptyFrame(1, 1)).iou, 0.0);
}

TEST(SilhouetteIou, EmptyInBoth_IsAbsentNotZero) {
    const Frame nothing = emptyFrame(4, 4);
    const SilhouetteIou result = pooled(nothing, nothing, {objectWithRelief(1, 0.1)});
    EXPECT_FALSE(result.iou);
    EXPECT_THAT(result.iou.reason(), HasSubstr("neither frame"));
    EXPECT_EQ(result.unionPx, 0u);
}

// Two adjacent squares that change places: every pixel shows the wrong object, although coverage is equal.
TEST(SilhouetteIou, OtherObject_IsMissingAndExtra) {
    Frame reference = emptyFrame(4, 2), test = emptyFrame(4, 2);
    paintRectangle(reference, 0, 0, 2, 2, 1);
    paintRectangle(reference, 2, 0, 4, 2, 2);
    paintRectangle(test, 0, 0, 2, 2, 2);
    paintRectangle(test, 2, 0, 4, 2, 1);
    const SilhouetteIou result = pooled(reference, test);
    EXPECT_EQ(*result.iou, 0.0);
    EXPECT_EQ(result.missingPx, 8u);
    EXPECT_EQ(result.extraPx, 8u);
}

TEST(SilhouetteIou, NoId_UsesCoverage) {
    Frame reference = emptyFrame(4, 1);
    paintRectangle(reference, 0, 0, 2, 1, 5);
    Frame test(4, 1);
    const auto coverage = test.add("A");
    coverage[0] = 1;
    coverage[1] = 0.5f;  // the threshold counts as covered
    coverage[2] = 0.49f; // just below it doesn't
    coverage[3] = kNanF;
    const FramePair pair(reference, test, {});
    EXPECT_FALSE(pair.hasObjectIds());
    const SilhouetteIou result = computeSilhouetteIou(pair, allOf(pair));
    EXPECT_EQ(*result.iou, 1.0);
    EXPECT_EQ(result.unionPx, 2u);
}

TEST(FramePair, NanId_IsMiss) {
    Frame frame = emptyFrame(2, 1);
    paintPixel(frame, 0, 0, 1, 2);
    set(frame, "id", 1, 0, kNanF);
    EXPECT_EQ(pooled(frame, frame).unionPx, 1u);
}

TEST(FramePair, IncomparableFrames_AreRefused) {
    const Frame good = emptyFrame(2, 2);
    const auto message = [](const Frame& reference, const Frame& test) -> std::string {
        try {
            FramePair(reference, test, {});
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(message(good, emptyFrame(2, 3)), HasSubstr("2 x 2 pixels, the test 2 x 3"));
    Frame depthOnly(2, 2);
    depthOnly.add("Z");
    EXPECT_THAT(message(good, depthOnly), HasSubstr("test: "));
    EXPECT_THAT(message(depthOnly, good), HasSubstr("channel A"));
    for (const float bad : {0.5f, -1.0f, 65536.0f, 3e38f, kInfinityF, -kInfinityF}) {
        Frame odd = good;
        set(odd, "id", 1, 0, bad);
        EXPECT_THAT(message(good, odd), HasSubstr("pixel (1, 0)")) << bad;
    }
}

TEST(FramePair, UnknownObjects_AreNamedByNumber) {
    Frame frame = emptyFrame(2, 1);
    paintPixel(frame, 0, 0, 7, 2);
    const FramePair pair(frame, frame, {objectWithRelief(1, 0.1)});
    ASSERT_EQ(pair.objects().size(), 2u);
    EXPECT_EQ(pair.objects()[1].id, 7);
    EXPECT_FALSE(pair.objects()[1].reliefDepth);
}

TEST(FramePair, Pool_ContainsReliefObjects) {
    const Frame frame = emptyFrame(1, 1);
    EXPECT_EQ(FramePair(frame, frame, {objectWithRelief(1, 0), objectWithRelief(2, 0.1)}).reliefObjects(),
              std::vector<size_t>{1});
    EXPECT_EQ(FramePair(frame, frame, {objectWithRelief(1, 0), objectWithRelief(2, 0)}).reliefObjects(),
              (std::vector<size_t>{0, 1}));
}

/// Pixels of an object as coordinates, for a brute-force computation from the definition.
std::set<std::pair<int, int>> pixelsShowing(const Frame& frame, int id) {
    std::set<std::pair<int, int>> pixels;
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x)
            if (frame.channel("id")[static_cast<size_t>(y * frame.width() + x)] == static_cast<float>(id))
                pixels.emplace(x, y);
    return pixels;
}

RC_GTEST_PROP(SilhouetteIouProperty, RandomFrames_EqualPixelSets, ()) {
    const Frame reference = randomFrame(), test = randomFrame();
    size_t shared = 0, either = 0;
    for (int id = 1; id <= 3; ++id) {
        const auto a = pixelsShowing(reference, id), b = pixelsShowing(test, id);
        auto both = a;
        both.insert(b.begin(), b.end());
        either += both.size();
        for (const auto& pixel : a)
            shared += b.count(pixel);
    }
    const SilhouetteIou result = pooled(reference, test, threeObjects());
    RC_ASSERT(result.intersectionPx == shared);
    RC_ASSERT(result.unionPx == either);
    if (either > 0)
        RC_ASSERT(*result.iou == static_cast<double>(shared) / static_cast<double>(either));
    else
        RC_ASSERT(!result.iou);
}

RC_GTEST_PROP(SilhouetteIouProperty, SwappedFrames_SwapMissingAndExtra, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const SilhouetteIou there = pooled(a, b), back = pooled(b, a);
    RC_ASSERT(there.iou == back.iou);
    RC_ASSERT(there.missingPx == back.extraPx);
    RC_ASSERT(there.extraPx == back.missingPx);
}

RC_GTEST_PROP(SilhouetteIouProperty, FlippedFrames_AreEqual, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const Figure iou = pooled(a, b).iou;
    RC_ASSERT(pooled(flippedHorizontally(a), flippedHorizontally(b)).iou == iou);
    RC_ASSERT(pooled(flippedVertically(a), flippedVertically(b)).iou == iou);
}

} // namespace
} // namespace plumbline
