// Compares intervals with their definition: the metric is computed for every true image that the reference's
// uncertain pixels allow.
#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/depth_error.h"
#include "validate/metrics/shadow_agreement.h"
#include "validate/metrics/silhouette_iou.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

constexpr int kObjects = 3;

/// What a true image may show at a pixel.
struct Truth {
    int id = 0;
    float shadow = 0;
};

/// The definition of validate/README.md at a pixel; the objects of the scene have the ids 1 … kObjects.
std::vector<Truth> truthsAt(const Frame& reference, size_t pixel) {
    const int id = static_cast<int>(reference.channel("id")[pixel]);
    const float shadow = reference.channel("shadow.sun")[pixel];
    const bool shadowUncertain =
        reference.channel("uncertain.shadow.sun")[pixel] > 0 && std::isfinite(shadow);
    std::vector<Truth> truths{{id, shadow}};
    if (id > 0 && shadowUncertain) truths.push_back({id, 1 - shadow});
    if (reference.channel("uncertain")[pixel] == 0) return truths;
    for (int other = 0; other <= kObjects; ++other) {
        if (other == id && (other == 0 || std::isfinite(shadow)))
            continue; // as in the reference, added above
        if (other == 0)
            truths.push_back({0, kNanF});
        else
            for (const float lit : {0.0f, 1.0f})
                truths.push_back({other, lit});
    }
    return truths;
}

/// Calls visit(image) for each true image, that is, for each combination of truths.
void forEachTruth(Frame& image, size_t pixel, const std::function<void(const Frame&)>& visit) {
    if (pixel == image.pixelCount()) {
        visit(image);
        return;
    }
    const float id = image.channel("id")[pixel], shadow = image.channel("shadow.sun")[pixel];
    for (const Truth& truth : truthsAt(image, pixel)) {
        Frame& chosen = image;
        chosen.channel("id")[pixel] = static_cast<float>(truth.id);
        chosen.channel("shadow.sun")[pixel] = truth.shadow;
        forEachTruth(chosen, pixel + 1, visit);
        chosen.channel("id")[pixel] = id; // truthsAt needs the reference's own values
        chosen.channel("shadow.sun")[pixel] = shadow;
    }
}

/// Smallest and largest value so far.
struct Extremes {
    std::optional<double> low, high;
    void add(const Figure& figure) {
        if (!figure) return;
        low = std::min(low.value_or(*figure), *figure);
        high = std::max(high.value_or(*figure), *figure);
    }
};

/// Equal bit for bit, because numerators and denominators are the same integers or have exactly equal
/// quotients.
void requireEqual(const Interval& interval, const Figure& figure, const Extremes& extremes) {
    RC_ASSERT(static_cast<bool>(interval.low) == static_cast<bool>(figure));
    RC_ASSERT(static_cast<bool>(interval.high) == static_cast<bool>(figure));
    if (!figure) return;
    RC_ASSERT(*interval.low == *extremes.low);
    RC_ASSERT(*interval.high == *extremes.high);
    RC_ASSERT(*interval.low <= *figure);
    RC_ASSERT(*figure <= *interval.high);
}

constexpr int kWidth = 6;

Frame randomRow() {
    Frame frame = emptyFrame(kWidth, 1);
    for (int x = 0; x < kWidth; ++x) {
        const int id = *rc::gen::inRange(0, kObjects + 1);
        if (id == 0) continue;
        paintPixel(frame, x, 0, id, 2);
        set(frame, "shadow.sun", x, 0, static_cast<float>(*rc::gen::inRange(0, 2)));
        if (*rc::gen::inRange(0, 10) == 0) set(frame, "shadow.sun", x, 0, kNanF);
    }
    return frame;
}

/// At most three pixels with an uncertain object, with up to 7 truths each, and some with an uncertain
/// shadow.
Frame randomReference() {
    Frame frame = randomRow();
    addUncertainty(frame);
    int left = 3;
    for (int x = 0; x < kWidth; ++x) {
        if (left > 0 && *rc::gen::inRange(0, 2) == 1) {
            set(frame, "uncertain", x, 0, 1);
            --left;
        }
        set(frame, "uncertain.shadow.sun", x, 0, *rc::gen::inRange(0, 3) == 0 ? 1.0f : 0.0f);
    }
    return frame;
}

/// Some of the objects, at least one.
std::vector<size_t> randomSelection() {
    std::vector<size_t> selection;
    const int chosen = *rc::gen::inRange(1, 1 << kObjects);
    for (size_t i = 0; i < kObjects; ++i)
        if (chosen >> i & 1) selection.push_back(i);
    return selection;
}

RC_GTEST_PROP(UncertaintyProperty, SilhouetteInterval_EqualsAllTrueImages, ()) {
    const Frame reference = randomReference(), test = randomRow();
    const std::vector<size_t> selection = randomSelection();
    Extremes iou;
    Frame image = reference;
    forEachTruth(image, 0, [&](const Frame& truth) {
        iou.add(computeSilhouetteIou(FramePair(truth, test, threeObjects()), selection).iou);
    });
    const SilhouetteIou result = computeSilhouetteIou(FramePair(reference, test, threeObjects()), selection);
    requireEqual(result.iouRange, result.iou, iou);
}

RC_GTEST_PROP(UncertaintyProperty, ShadowIntervals_EqualAllTrueImages, ()) {
    const Frame reference = randomReference(), test = randomRow();
    const std::vector<size_t> selection = randomSelection();
    Extremes agreement, iou, f1;
    Frame image = reference;
    forEachTruth(image, 0, [&](const Frame& truth) {
        const auto plain = computeShadowAgreement(FramePair(truth, test, threeObjects()), selection, "sun");
        agreement.add(plain.agreement);
        iou.add(plain.iou);
        f1.add(plain.f1);
    });
    const auto result = computeShadowAgreement(FramePair(reference, test, threeObjects()), selection, "sun");
    requireEqual(result.agreementRange, result.agreement, agreement);
    requireEqual(result.iouRange, result.iou, iou);
    requireEqual(result.f1Range, result.f1, f1);
}

RC_GTEST_PROP(UncertaintyProperty, CertainFrames_HaveZeroWidth, ()) {
    Frame reference = randomFrame();
    const Frame test = randomFrame();
    addUncertainty(reference);
    const FramePair pair(reference, test, threeObjects());
    const SilhouetteIou silhouette = computeSilhouetteIou(pair, allOf(pair));
    RC_ASSERT(silhouette.iouRange.low == silhouette.iou);
    RC_ASSERT(silhouette.iouRange.high == silhouette.iou);
    RC_ASSERT(*silhouette.uncertainPx == 0);
    const ShadowAgreement shadow = computeShadowAgreement(pair, allOf(pair), "sun");
    RC_ASSERT(shadow.agreementRange.low == shadow.agreement);
    RC_ASSERT(shadow.agreementRange.high == shadow.agreement);
    RC_ASSERT(shadow.f1Range.high == shadow.f1);
    RC_ASSERT(*shadow.uncertainPx == 0);
}

// Reference 1 1 1 . . .    IoU 2/4: shared 1 2, missing 0, extra 3. Uncertain: 2 (shared), 3 (extra), 5
// (neither). Test      . 1 1 1 . .    low: 5 shows the object, 2 and 3 don't: 1/5. high: 2 and 3 show it, 5
// doesn't: 3/4.
TEST(Uncertainty, Silhouette_EqualsHandComputed) {
    Frame reference = emptyFrame(6, 1), test = emptyFrame(6, 1);
    paintRectangle(reference, 0, 0, 3, 1);
    paintRectangle(test, 1, 0, 4, 1);
    addUncertainty(reference);
    for (const int x : {2, 3, 5})
        set(reference, "uncertain", x, 0, 1);
    const FramePair pair(reference, test, {objectWithRelief(1, 0.1)});
    const SilhouetteIou result = computeSilhouetteIou(pair, allOf(pair));
    EXPECT_EQ(*result.iou, 2.0 / 4.0);
    EXPECT_EQ(*result.iouRange.low, 1.0 / 5.0);
    EXPECT_EQ(*result.iouRange.high, 3.0 / 4.0);
    EXPECT_EQ(*result.uncertainPx, 3);
    EXPECT_EQ(*computeDepthError(pair, allOf(pair), reference.channel("Z"), test.channel("Z")).uncertainPx,
              1);
}

// If two objects are pooled, an uncertain pixel may show the other one, from which it is missing, while it is
// extra in the one drawn. Three pixels of object 1 in both frames, one uncertain: at least 2/4; for object 1
// alone 2/3.
TEST(Uncertainty, OtherPooledObject_CountsTwice) {
    Frame reference = emptyFrame(3, 1), test = emptyFrame(3, 1);
    paintRectangle(reference, 0, 0, 3, 1);
    paintRectangle(test, 0, 0, 3, 1);
    addUncertainty(reference);
    set(reference, "uncertain", 0, 0, 1);
    const FramePair pair(reference, test, {objectWithRelief(1, 0.1), objectWithRelief(2, 0.1)});
    EXPECT_EQ(*computeSilhouetteIou(pair, allOf(pair)).iouRange.low, 2.0 / 4.0);
    EXPECT_EQ(*computeSilhouetteIou(pair, std::vector<size_t>{0}).iouRange.low, 2.0 / 3.0);
    EXPECT_EQ(*computeSilhouetteIou(pair, std::vector<size_t>{0}).iouRange.high, 1.0);
}

// Four lit pixels that agree. The shadow of pixel 0 is uncertain, pixel 1 may leave the domain, and pixel 4,
// which only the test covers, may enter it.
//   agreement: high 4/4; low: 0 is wrong, 1 is outside, 4 is inside and wrong: 2/4.
//   IoU and its interval are absent, because neither frame has a shadow.
TEST(Uncertainty, Shadow_EqualsHandComputed) {
    Frame reference = emptyFrame(5, 1), test = emptyFrame(5, 1);
    paintRectangle(reference, 0, 0, 4, 1);
    paintRectangle(test, 0, 0, 5, 1);
    addUncertainty(reference);
    set(reference, "uncertain.shadow.sun", 0, 0, 1);
    set(reference, "uncertain", 1, 0, 1);
    set(reference, "uncertain", 4, 0, 1);
    const FramePair pair(reference, test, {objectWithRelief(1, 0.1)});
    const ShadowAgreement result = computeShadowAgreement(pair, allOf(pair), "sun");
    EXPECT_EQ(*result.agreement, 1.0);
    EXPECT_EQ(*result.agreementRange.low, 2.0 / 4.0);
    EXPECT_EQ(*result.agreementRange.high, 1.0);
    EXPECT_EQ(*result.uncertainPx, 3);
    EXPECT_EQ(result.iouRange.low.reason(), result.iou.reason());
}

TEST(Uncertainty, NanValue_IsUncertain) {
    Frame reference = emptyFrame(3, 1), test = emptyFrame(3, 1);
    paintRectangle(reference, 0, 0, 3, 1);
    addUncertainty(reference);
    set(reference, "uncertain", 0, 0, kNanF);
    set(reference, "uncertain", 1, 0, 0.5f);
    set(reference, "uncertain", 2, 0, 0.4f);
    EXPECT_EQ(FramePair(reference, test, {}).uncertainPixels().size(), 2u);
}

TEST(Uncertainty, NoChannels_HaveNoInterval) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    const auto silhouette = [](const FramePair& pair) { return computeSilhouetteIou(pair, allOf(pair)); };
    const auto shadow = [](const FramePair& pair) {
        return computeShadowAgreement(pair, allOf(pair), "sun");
    };
    const std::string noUncertain = "the reference frame has no channel uncertain";
    Frame certainInTest = frame; // the test's channels don't describe the reference
    addUncertainty(certainInTest);
    const FramePair without(frame, certainInTest, {});
    EXPECT_EQ(silhouette(without).iouRange.low.reason(), noUncertain);
    EXPECT_EQ(silhouette(without).uncertainPx.reason(), noUncertain);
    EXPECT_EQ(shadow(without).agreementRange.high.reason(), noUncertain);
    EXPECT_EQ(computeDepthError(without, allOf(without), frame.channel("Z"), frame.channel("Z"))
                  .uncertainPx.reason(),
              noUncertain);

    Frame coverageOnly = frame;
    coverageOnly.add("uncertain");
    const FramePair half(coverageOnly, frame, {});
    EXPECT_EQ(*silhouette(half).iouRange.low, 1);
    EXPECT_EQ(shadow(half).f1Range.low.reason(), noUncertain + ".shadow.sun");
    EXPECT_FALSE(shadow(half).uncertainPx);
}

} // namespace
} // namespace plumbline
