#include "tests/validate/metrics/random_frames.h"
#include "validate/compare/compare.h"
#include "validate/metrics/metric_registry.h"
#include "validate/results/results.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RC_GTEST_PROP(CompareProperty, PooledCounts_AreSumsOfReliefObjects, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    auto objects = threeObjects();
    objects[1].reliefDepth = 0; // object 2 has no relief: listed, but not pooled
    const Comparison result = compareFrames(a, b, objects, std::nullopt);
    const MetricSet &one = result.objects[0].metrics, &three = result.objects[2].metrics;
    RC_ASSERT(result.pooledObjects == (std::vector<std::string>{"object 1", "object 3"}));
    for (const char* key :
         {"silhouette.union_px", "depth.domain_px", "depth.badpix_5pct_px", "shadow.false_lit_px"})
        RC_ASSERT(*result.pooled.figure(key, "sun") == *one.figure(key, "sun") + *three.figure(key, "sun"));
}

TEST(Compare, FrameWithItself_HasNoError) {
    Frame frame = emptyFrame(8, 8);
    paintRectangle(frame, 1, 1, 6, 7);
    set(frame, "shadow.sun", 3, 3, 1);
    const MetricSet metrics = compareFrames(frame, frame, {objectWithRelief(1, 0.1)}, std::nullopt).pooled;
    for (const MetricInfo& metric : metricTable()) {
        const Figure& figure = metrics.figure(metric, "sun");
        if (!figure) continue;
        if (metric.goal == Goal::One) {
            EXPECT_EQ(*figure, 1) << metric.key;
        } else if (metric.goal == Goal::Zero) {
            EXPECT_EQ(*figure, 0) << metric.key;
        }
    }
    for (const char* key :
         {"silhouette.iou", "silhouette.boundary_iou.1px", "silhouette.hausdorff95_px", "depth.max",
          "depth.rmse_relief", "shadow.agreement", "normal.p95_degrees", "st.p95_texels", "image.rmse"})
        EXPECT_TRUE(metrics.figure(key, "sun")) << key;
}

TEST(Compare, MissingChannels_AreNoted) {
    Frame reference = emptyFrame(2, 1);
    paintRectangle(reference, 0, 0, 2, 1);
    Frame test(2, 1);
    const auto coverage = test.add("A");
    coverage[0] = coverage[1] = 1;
    const Comparison result = compareFrames(reference, test, {}, std::nullopt);
    EXPECT_THAT(result.notes, Contains(HasSubstr("no channel id: all covered pixels count as one object")));
    EXPECT_THAT(result.notes,
                Contains(HasSubstr("the test frame has neither Z nor P.X P.Y P.Z: no depth figures")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("no shadow figures for sun")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("no normal figures")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("no st figures")));
    EXPECT_THAT(result.notes, Contains(HasSubstr("the test frame has no channel R: no image figures")));
    EXPECT_EQ(*result.pooled.figure("silhouette.iou"), 1);
    EXPECT_FALSE(result.pooled.figure("depth.mae"));
    EXPECT_FALSE(result.pooled.figure("shadow.agreement", "sun"));
}

TEST(Compare, NoUncertainChannels_AreNoted) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    frame.metadata["light.sun"] = "to_light 0 0 1";
    const auto notes = compareFrames(frame, frame, {objectWithRelief(1, 0.1)}, Camera()).notes;
    EXPECT_THAT(notes,
                ElementsAre("the reference frame has no channel uncertain.shadow.sun: no intervals of the "
                            "shadow figures for sun",
                            "the reference frame has no channel uncertain: no intervals"));
}

TEST(Compare, CompleteFrames_HaveNoNotes) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    addUncertainty(frame);
    frame.metadata["light.sun"] = "to_light 0 0 1";
    EXPECT_THAT(compareFrames(frame, frame, {objectWithRelief(1, 0.1)}, Camera()).notes, IsEmpty());
}

// paintPixel's normal is +z, and the camera is on that side: a light in front causes no attached shadows, one
// behind only attached shadows.
TEST(Compare, Lights_ComeFromReferencesHeaderFirst) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    Frame lit = frame, dark = frame;
    lit.metadata["light.sun"] = "to_light 0 0 1";
    dark.metadata["light.sun"] = "to_light 0 0 -1";
    const auto castPx = [](const Frame& reference, const Frame& test) {
        return *compareFrames(reference, test, {}, Camera()).pooled.figure("shadow.cast_domain_px", "sun");
    };
    EXPECT_EQ(castPx(lit, dark), 2);
    EXPECT_EQ(castPx(dark, lit), 0);
    EXPECT_EQ(castPx(frame, lit), 2);
    Frame other = frame; // its header has a light without a channel
    other.metadata["light.fill"] = "to_light 0 0 -1";
    EXPECT_EQ(castPx(other, lit), 2);
    const Comparison unknown = compareFrames(frame, frame, {}, Camera());
    EXPECT_THAT(unknown.notes,
                Contains(HasSubstr("neither header contains the direction or position of the light")));
    EXPECT_FALSE(unknown.pooled.figure("shadow.cast_agreement", "sun"));
    EXPECT_THAT(compareFrames(lit, lit, {}, std::nullopt).notes,
                Contains(HasSubstr("the camera is not known: attached and cast")));
}

// Parallel tasks write separate figures, so one thread gives the same result as all.
TEST(Compare, AnyThreadCount_GivesEqualResult) {
    Frame reference = emptyFrame(64, 48);
    paintRectangle(reference, 5, 5, 40, 40, 1);
    paintRectangle(reference, 20, 10, 60, 30, 2);
    reference.metadata["light.sun"] = "position 1 2 3";
    addUncertainty(reference);
    set(reference, "uncertain", 5, 5, 1);
    const Frame test = shiftedRight(reference);
    const auto results = [&] {
        Results outcome;
        outcome.techniques.resize(1);
        outcome.techniques[0].comparison = compareFrames(reference, test, threeObjects(), Camera());
        return toJson(outcome);
    };
    const std::string all = results();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(results(), all);
}

// Camera at (0, 0, 3) looking down -z: the point (5, 7, 1) has the planar depth 2, independent of x and y.
TEST(PlanarDepth, NoZ_UsesPositionsAndCamera) {
    Frame frame(1, 1);
    frame.add("P.X")[0] = 5;
    frame.add("P.Y")[0] = 7;
    frame.add("P.Z")[0] = 1;
    Camera camera;
    camera.positionWorld = {0, 0, 3};
    camera.targetWorld = {0, 0, 0};
    EXPECT_THAT(planarDepth(frame, "test", camera).depth, ElementsAre(2.0f));
    EXPECT_THAT(planarDepth(frame, "test", std::nullopt).reason, HasSubstr("camera is not known"));
    frame.add("Z")[0] = 9; // Z takes precedence and needs no camera
    EXPECT_THAT(planarDepth(frame, "test", camera).depth, ElementsAre(9.0f));
}

} // namespace
} // namespace plumbline
