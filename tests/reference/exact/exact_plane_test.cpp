// Compares frames of the reference with the exact tracer: pixels that aren't marked as uncertain must be
// correct.
#include "reference/reference.h"
#include "tests/reference/exact/exact_picture.h"
#include "tests/reference/exact/exact_scenes.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace plumbline {
namespace {

// Marking everything as uncertain must not pass. In these scenes 1.5 to 3 % of all pixels are within half a
// pixel of the silhouette, and at the finest rate the error of micro-triangles is smaller. Of the covered
// pixels, up to 15 % are within 1/8 pixel of a shadow's edge and up to 28 % within 1/4; a light 5 degrees
// above the plane magnifies an error 11 times. The error bounds are per grid of 16 x 16 micro-cells and a few
// times larger than the error at most of its points.
constexpr double kMaxUncertain = 0.03;
constexpr double kMaxShadowUncertain = 0.4;
// A frame that shows another part of the surface everywhere must not pass either: fins at 85 degrees have 1.5
// % such pixels.
constexpr double kMaxJumped = 0.03;

// With two segments per texel, or a third of one, creases are cut off and needles are lost. Many pixels are
// uncertain, including all shadows of needles, and must be marked.
constexpr int kCoarseRate = 128;
constexpr double kMaxUncertainWhenCoarse = 0.25;
constexpr double kMaxWrongDepthWhenCoarse = 0.02;

// Where one part of the surface occludes another, the edge may be displaced by the certificate's error; twice
// that, because the error is measured in the visible cells and the edge may be in the adjacent ones; but at
// least by the displacement of rays rounded to float.
constexpr double kJumpPerCertificate = 2;
constexpr double kRayRoundingPx = 1.0 / 256;

class ExactPlaneFrame : public testing::TestWithParam<ExactScene> {
  protected:
    /// Renders at a rate, compares with the exact picture and prints the counts; fails for any error in a
    /// certain pixel.
    void compareWithExactTracer(int rate) {
        const Scene& scene = GetParam().scene;
        ReferenceOptions options;
        options.rate = rate;
        ReferenceScene reference(scene, options);
        const Frame frame = reference.render();
        const double certificatePx = *reference.stats().certificate.pxMax;
        comparison =
            compareWithExact(scene, frame, std::max(kRayRoundingPx, kJumpPerCertificate * certificatePx));
        std::printf("%s, rate %d, certificate %.3g px: %s\n", GetParam().name.c_str(), rate, certificatePx,
                    comparison.summary().c_str());
        ASSERT_TRUE(frame.has("uncertain")) << "the reference has no channel 'uncertain'";
        for (const Light& light : scene.lights)
            ASSERT_TRUE(frame.has(uncertainShadowChannel(light.name)))
                << "the reference doesn't mark uncertain pixels of that shadow";
        EXPECT_EQ(comparison.coverageWrong, 0) << lines();
        EXPECT_EQ(comparison.shadowWrong, 0) << lines();
        EXPECT_GT(comparison.covered, comparison.pixels / 10) << "the scene covers too few pixels";
    }

    std::string lines() const {
        std::string joined = "first that are wrong:";
        for (const std::string& line : comparison.firstWrong)
            joined += "\n  " + line;
        return joined;
    }

    Comparison comparison;
};

TEST_P(ExactPlaneFrame, CertainPixels_AreRight) {
    ASSERT_NO_FATAL_FAILURE(compareWithExactTracer(GetParam().fineRate));
    EXPECT_EQ(comparison.depthWrong, 0) << lines();
    EXPECT_LT(comparison.uncertainShare(), kMaxUncertain);
    EXPECT_LT(comparison.shadowUncertainShare(), kMaxShadowUncertain);
    EXPECT_LT(comparison.depthJumped, kMaxJumped * comparison.covered);
}

TEST_P(ExactPlaneFrame, CertainPixelsOfCoarseRun_AreRight) {
    ASSERT_NO_FATAL_FAILURE(compareWithExactTracer(kCoarseRate));
    // Depth has no separate mark where another part of the same object may be visible.
    EXPECT_LT(comparison.depthWrong, kMaxWrongDepthWhenCoarse * comparison.depthCompared) << lines();
    EXPECT_LT(comparison.uncertainShare(), kMaxUncertainWhenCoarse);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactPlaneFrame, testing::ValuesIn(exactScenes()),
                         [](const testing::TestParamInfo<ExactScene>& scene) { return scene.param.name; });

} // namespace
} // namespace plumbline
