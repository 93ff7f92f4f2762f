// Frames of the reference against the exact tracer: where the reference doesn't call itself uncertain, it
// must be right.
#include "reference/reference.h"
#include "tests/reference/exact/exact_picture.h"
#include "tests/reference/exact/exact_scenes.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace plumbline {
namespace {

// Calling everything uncertain must not pass. In these scenes 1.5 to 3 % of all pixels are within half a
// pixel of the silhouette, and at the finest rate micro-triangles are off by less than that. Of the covered
// pixels up to 15 % are within 1/8 pixel of a shadow's edge, and up to 28 % within 1/4; a light 5 degrees
// above the plane carries an error 11 times as far. The bounds are those of a grid of 16 x 16 micro-cells, a
// few times the error of most places in it.
constexpr double kMostUncertain = 0.03;
constexpr double kMostShadowUncertain = 0.4;
// Nor must a frame with another part of the surface everywhere: fins at 85 degrees have 1.5 % such pixels.
constexpr double kMostJumped = 0.03;

// With two segments a texel, or a third of one, creases are cut off and needles lost: much is uncertain, of
// the shadows of needles all, and must be called so.
constexpr int kCoarseRate = 128;
constexpr double kMostUncertainWhenCoarse = 0.25;
constexpr double kMostWrongDepthWhenCoarse = 0.02;

// Where one part of the surface hides another, the edge may be off by what the certificate says; twice that,
// as it is measured in the cells seen, and the edge's may be the next ones; and never less than what rounding
// rays to float moves them.
constexpr double kJumpPerCertificate = 2;
constexpr double kRayRoundingPx = 1.0 / 256;

class ExactPlaneFrame : public testing::TestWithParam<ExactScene> {
  protected:
    /// Renders at a rate, compares, prints the counts; fails for anything wrong where the frame is certain.
    void holdAgainstExact(int rate) {
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
        ASSERT_TRUE(frame.has("uncertain")) << "the reference doesn't say where it is uncertain";
        for (const Light& light : scene.lights)
            ASSERT_TRUE(frame.has(uncertainShadowChannel(light.name)))
                << "the reference doesn't say where that shadow is";
        EXPECT_EQ(comparison.coverageWrong, 0) << lines();
        EXPECT_EQ(comparison.shadowWrong, 0) << lines();
        EXPECT_GT(comparison.covered, comparison.pixels / 10) << "the scene shows too little to say anything";
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
    ASSERT_NO_FATAL_FAILURE(holdAgainstExact(GetParam().fineRate));
    EXPECT_EQ(comparison.depthWrong, 0) << lines();
    EXPECT_LT(comparison.uncertainShare(), kMostUncertain);
    EXPECT_LT(comparison.shadowUncertainShare(), kMostShadowUncertain);
    EXPECT_LT(comparison.depthJumped, kMostJumped * comparison.covered);
}

TEST_P(ExactPlaneFrame, CertainPixelsOfCoarseRun_AreRight) {
    ASSERT_NO_FATAL_FAILURE(holdAgainstExact(kCoarseRate));
    // Depth has no mark of its own where another part of the same object could be seen.
    EXPECT_LT(comparison.depthWrong, kMostWrongDepthWhenCoarse * comparison.depthCompared) << lines();
    EXPECT_LT(comparison.uncertainShare(), kMostUncertainWhenCoarse);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactPlaneFrame, testing::ValuesIn(exactScenes()),
                         [](const testing::TestParamInfo<ExactScene>& scene) { return scene.param.name; });

} // namespace
} // namespace plumbline
