// Faults of painted frames.
#include "tests/validate/metrics/painted_frames.h"
#include "validate/metrics/hit_faults.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

HitFaults faultsOf(const Frame& frame) {
    const FramePair pair(frame, frame, {});
    return computeHitFaults(pair, allOf(pair));
}

TEST(HitFaults, MarkedPixels_AreCountedByKind) {
    Frame frame = emptyFrame(8, 1);
    paintRectangle(frame, 0, 0, 6, 1); // two pixels remain uncovered
    frame.add("fault");
    const float marks[] = {1, 2, 4, 6, 0, 99, 7, 7};
    for (int x = 0; x < 8; ++x)
        set(frame, "fault", x, 0, marks[x]);
    const HitFaults faults = faultsOf(frame);
    EXPECT_EQ(faults.notFinitePx, 1u);
    EXPECT_EQ(*faults.tOutsidePx, 2);
    EXPECT_EQ(*faults.offRayPx, 2);
    EXPECT_THAT(
        faultSentences(frame),
        ElementsAre(HasSubstr("1 covered pixels have a position, depth, normal or st that isn't a number"),
                    HasSubstr("2 covered pixels have a hit with t outside [0, 1]"),
                    HasSubstr("2 covered pixels have a hit whose st isn't the ray's")));
}

TEST(HitFaults, EachChannelsNan_IsCounted) {
    for (const char* channel : {"Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S", "st.T"}) {
        Frame frame = emptyFrame(3, 1);
        paintRectangle(frame, 0, 0, 2, 1);
        EXPECT_EQ(faultsOf(frame).notFinitePx, 0u) << channel;
        EXPECT_THAT(faultSentences(frame), IsEmpty());
        set(frame, channel, 1, 0, kInfinityF);
        EXPECT_EQ(faultsOf(frame).notFinitePx, 1u) << channel;
    }
}

TEST(HitFaults, FrameWithoutMarks_HasReasons) {
    Frame frame = emptyFrame(2, 1);
    paintPixel(frame, 0, 0, 1, 2);
    const HitFaults faults = faultsOf(frame);
    EXPECT_FALSE(faults.tOutsidePx);
    EXPECT_THAT(faults.offRayPx.reason(), HasSubstr("no channel fault"));
}

} // namespace
} // namespace plumbline
