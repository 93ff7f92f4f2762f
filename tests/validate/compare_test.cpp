#include "../../validate/compare.h"
#include "random_frames.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RC_GTEST_PROP(CompareProperty, PooledCountsAreTheSumsOfTheReliefObjects, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    auto objects = threeObjects();
    objects[1].reliefDepth = 0; // object 2 has no relief: in the list, not in the pool
    const Comparison result = compareFrames(a, b, objects, std::nullopt);
    const MetricSet &one = result.objects[0].metrics, &three = result.objects[2].metrics;
    RC_ASSERT(result.pooledObjects == (std::vector<std::string>{"object 1", "object 3"}));
    RC_ASSERT(result.pooled.silhouette.unionPx == one.silhouette.unionPx + three.silhouette.unionPx);
    RC_ASSERT(result.pooled.depth.domainPx == one.depth.domainPx + three.depth.domainPx);
    RC_ASSERT(result.pooled.depth.bad5pctPx == one.depth.bad5pctPx + three.depth.bad5pctPx);
    RC_ASSERT(result.pooled.shadow.at("sun").falseLitPx ==
              one.shadow.at("sun").falseLitPx + three.shadow.at("sun").falseLitPx);
}

TEST(Compare, AFrameWithItself) {
    Frame frame = emptyFrame(8, 8);
    paintRectangle(frame, 1, 1, 6, 7);
    set(frame, "shadow.sun", 3, 3, 1);
    const MetricSet metrics = compareFrames(frame, frame, {objectWithRelief(1, 0.1)}, std::nullopt).pooled;
    EXPECT_EQ(*metrics.silhouette.iou, 1);
    EXPECT_EQ(*metrics.contour.hausdorff95Px, 0);
    EXPECT_EQ(*metrics.depth.world.max, 0);
    EXPECT_EQ(*metrics.depth.relief.rmse, 0);
    EXPECT_EQ(*metrics.shadow.at("sun").agreement, 1);
    EXPECT_EQ(*metrics.normal.p95Degrees, 0);
    EXPECT_EQ(*metrics.st.p95Texels, 0);
}

TEST(Compare, SaysWhatIsMissingAndWhatThatRulesOut) {
    Frame reference = emptyFrame(2, 1);
    paintRectangle(reference, 0, 0, 2, 1);
    Frame test(2, 1);
    const auto coverage = test.add("A");
    coverage[0] = coverage[1] = 1;
    const Comparison result = compareFrames(reference, test, {}, std::nullopt);
    EXPECT_THAT(result.notes, Contains(HasSubstr("no channel id: everything covered counts as one object")));
    EXPECT_THAT(result.notes,
                Contains(HasSubstr("the test frame has neither Z nor P.X P.Y P.Z: no depth figures")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("no shadow figures for sun")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("no normal figures")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("no st figures")));
    EXPECT_THAT(result.notes,
                Contains(HasSubstr("the test frame has no channel R: no figures of the picture")));
    EXPECT_EQ(*result.pooled.silhouette.iou, 1);
    EXPECT_FALSE(result.pooled.depth.world.mae);
    EXPECT_FALSE(result.pooled.shadow.at("sun").agreement);
}

TEST(Compare, SaysThatThereAreNoIntervals) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    const auto notes = compareFrames(frame, frame, {objectWithRelief(1, 0.1)}, std::nullopt).notes;
    EXPECT_THAT(notes,
                ElementsAre("the reference frame has no channel uncertain.shadow.sun: no intervals of the "
                            "shadow figures for sun",
                            "the reference frame has no channel uncertain: no intervals"));
}

TEST(Compare, NothingMissingMeansNoNotes) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    addUncertainty(frame);
    EXPECT_THAT(compareFrames(frame, frame, {objectWithRelief(1, 0.1)}, std::nullopt).notes, IsEmpty());
}

// Camera at (0, 0, 3) looking down -z: the point (5, 7, 1) has the planar depth 2, wherever it is sideways.
TEST(PlanarDepth, FromPositionsAndTheCamera) {
    Frame frame(1, 1);
    frame.add("P.X")[0] = 5;
    frame.add("P.Y")[0] = 7;
    frame.add("P.Z")[0] = 1;
    Camera camera;
    camera.positionWorld = {0, 0, 3};
    camera.targetWorld = {0, 0, 0};
    EXPECT_THAT(planarDepth(frame, "test", camera).depth, ElementsAre(2.0f));
    EXPECT_THAT(planarDepth(frame, "test", std::nullopt).reason, HasSubstr("camera is not known"));
    frame.add("Z")[0] = 9; // Z wins: it needs no camera
    EXPECT_THAT(planarDepth(frame, "test", camera).depth, ElementsAre(9.0f));
}

} // namespace
} // namespace plumbline
