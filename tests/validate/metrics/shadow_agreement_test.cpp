#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/shadow_agreement.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

ShadowAgreement pooled(const Frame& reference, const Frame& test, const std::string& light = "sun") {
    const FramePair pair(reference, test, {});
    return computeShadowAgreement(pair, allOf(pair), light);
}

/// One row of covered pixels, dark where the text has '#'.
Frame shadowRow(const std::string& row) {
    Frame frame = emptyFrame(static_cast<int>(row.size()), 1);
    paintRectangle(frame, 0, 0, frame.width(), 1);
    for (int x = 0; x < frame.width(); ++x)
        set(frame, "shadow.sun", x, 0, row[static_cast<size_t>(x)] == '#' ? 1.0f : 0.0f);
    return frame;
}

// Reference  # # # # . . . . . .     TP = 3 (0 1 2), FN = 1 (3), FP = 2 (4 5), TN = 4 (6 7 8 9)
// Test       # # # . # # . . . .
//   agreement 7/10    IoU 3/6    F1 6/9    BER = (2/6 + 1/4) / 2 = 7/24
TEST(ShadowAgreement, TenPixels_EqualHandComputed) {
    const ShadowAgreement result = pooled(shadowRow("####......"), shadowRow("###.##...."));
    EXPECT_EQ(result.domainPx, 10u);
    EXPECT_EQ(result.bothShadowPx, 3u);
    EXPECT_EQ(result.falseLitPx, 1u);
    EXPECT_EQ(result.falseShadowPx, 2u);
    EXPECT_EQ(result.bothLitPx, 4u);
    EXPECT_DOUBLE_EQ(*result.agreement, 0.7);
    EXPECT_DOUBLE_EQ(*result.iou, 0.5);
    EXPECT_DOUBLE_EQ(*result.f1, 6.0 / 9.0);
    EXPECT_DOUBLE_EQ(*result.ber, 7.0 / 24.0);
}

TEST(ShadowAgreement, IdenticalFrames_AreOne) {
    const Frame frame = shadowRow("##..");
    const ShadowAgreement result = pooled(frame, frame);
    EXPECT_EQ(*result.agreement, 1.0);
    EXPECT_EQ(*result.iou, 1.0);
    EXPECT_EQ(*result.f1, 1.0);
    EXPECT_EQ(*result.ber, 0.0);
}

TEST(ShadowAgreement, AllLit_HasNoIouOrErrorRate) {
    const Frame lit = shadowRow("....");
    const ShadowAgreement result = pooled(lit, lit);
    EXPECT_EQ(*result.agreement, 1.0);
    EXPECT_THAT(result.iou.reason(), HasSubstr("neither frame has a shadow"));
    EXPECT_FALSE(result.f1);
    EXPECT_THAT(result.ber.reason(), HasSubstr("in shadow in the reference"));
    EXPECT_THAT(pooled(shadowRow("####"), lit).ber.reason(), HasSubstr("lit in the reference"));
    EXPECT_EQ(*pooled(shadowRow("####"), lit).iou, 0.0);
}

TEST(ShadowAgreement, Penumbra_IsCutAtHalf) {
    Frame soft = shadowRow("...");
    set(soft, "shadow.sun", 0, 0, 0.5f);
    set(soft, "shadow.sun", 1, 0, 0.499f);
    const ShadowAgreement result = pooled(shadowRow("#.."), soft);
    EXPECT_EQ(*result.agreement, 1.0);
    EXPECT_EQ(result.bothShadowPx, 1u);
}

TEST(ShadowAgreement, PixelsWithoutValue_AreLeftOut) {
    Frame reference = shadowRow("####"), test = shadowRow("....");
    set(test, "id", 0, 0, 0);             // not covered
    set(test, "id", 1, 0, 2);             // another object
    set(test, "shadow.sun", 2, 0, kNanF); // no value
    const ShadowAgreement result = pooled(reference, test);
    EXPECT_EQ(result.domainPx, 1u);
    EXPECT_EQ(result.invalidPx, 1u);
    EXPECT_EQ(result.falseLitPx, 1u);
}

TEST(ShadowAgreement, NoChannel_IsAbsentWithReason) {
    const Frame frame = shadowRow("#.");
    Frame lightless(2, 1);
    const auto id = lightless.add("id");
    id[0] = id[1] = 1;
    EXPECT_EQ(pooled(frame, lightless).agreement.reason(), "the test frame has no channel shadow.sun");
    EXPECT_EQ(pooled(lightless, frame).ber.reason(), "the reference frame has no channel shadow.sun");
    EXPECT_EQ(pooled(frame, frame, "moon").f1.reason(), "neither frame has a channel shadow.moon");
    EXPECT_THAT(pooled(emptyFrame(2, 1), frame).iou.reason(), HasSubstr("same object"));
    Frame spoiled = frame;
    set(spoiled, "shadow.sun", 0, 0, kNanF);
    set(spoiled, "shadow.sun", 1, 0, kNanF);
    EXPECT_THAT(pooled(frame, spoiled).agreement.reason(), HasSubstr("finite"));
}

RC_GTEST_PROP(ShadowAgreementProperty, RandomFrames_EqualPlainVersion, ()) {
    const Frame reference = randomFrame(), test = randomFrame();
    // counts[in the reference][in the test], 0 lit, 1 dark
    uint64_t counts[2][2] = {};
    for (size_t i = 0; i < reference.pixelCount(); ++i) {
        if (reference.channel("id")[i] == 0 || reference.channel("id")[i] != test.channel("id")[i]) continue;
        const float a = reference.channel("shadow.sun")[i], b = test.channel("shadow.sun")[i];
        if (a == a && b == b) ++counts[a > 0.5f][b > 0.5f];
    }
    const ShadowAgreement result = pooled(reference, test);
    RC_ASSERT(result.bothLitPx == counts[0][0]);
    RC_ASSERT(result.falseShadowPx == counts[0][1]);
    RC_ASSERT(result.falseLitPx == counts[1][0]);
    RC_ASSERT(result.bothShadowPx == counts[1][1]);
    RC_ASSERT(result.domainPx == counts[0][0] + counts[0][1] + counts[1][0] + counts[1][1]);
    if (result.iou && *result.iou > 0) { // F1 = 2 IoU / (1 + IoU) for all counts
        RC_ASSERT(std::abs(*result.f1 - 2 * *result.iou / (1 + *result.iou)) < 1e-15);
    }
}

RC_GTEST_PROP(ShadowAgreementProperty, SwappedFrames_SwapErrors, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const ShadowAgreement there = pooled(a, b), back = pooled(b, a);
    RC_ASSERT(there.falseShadowPx == back.falseLitPx);
    RC_ASSERT(there.agreement == back.agreement);
    RC_ASSERT(there.iou == back.iou);
    const ShadowAgreement flipped = pooled(flippedHorizontally(a), flippedHorizontally(b));
    RC_ASSERT(there.ber == flipped.ber);
    RC_ASSERT(there.falseLitPx == flipped.falseLitPx);
}

} // namespace
} // namespace plumbline
