// Which errors the comparison with the exact picture detects, on an exact frame with pixels changed by hand.
#include "tests/reference/exact/exact_picture.h"
#include "tests/reference/test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr int kRow = 20; // of pixels, near the middle

// A step: z = 0 for x < -0.01 and -0.5 for x > 0.01, with 100 texels over the side of 2. The camera looks
// along (1, 0, -1) / sqrt 2 from (-4, 0, 4), so a point is (x + z) / sqrt 2 to the right of the center, which
// is at pixel 20 (pixels of 0.1), at a depth of (x - z + 8) / sqrt 2. The step's edge (-0.01, 0) is at 20 -
// 0.0707. Beyond it the floor is visible from x = 0.49 to its boundary, (1, -0.5), at 20 + 3.5355. The
// light's elevation is 1/2 per unit, so behind the edge the floor is lit from x = 0.99 on, at 20 + 3.4648.
Scene stepScene() {
    std::vector<float> depths(100, 0.0f);
    std::fill(depths.begin() + 50, depths.end(), 1.0f);
    Scene scene =
        squareScene(std::make_shared<HeightMap>("step", 100, 1, depths, Wrap::Clamp, Wrap::Clamp), 0.5);
    scene.camera.positionWorld = {-4, 0, 4};
    scene.lights[0].toLightWorld = glm::normalize(Vec3(-2, 0, 1));
    return scene;
}

/// Depth of the top and of the floor at a point, where x + z = across sqrt 2.
double topDepth(double place) {
    return ((place - 20) * 0.1 * std::sqrt(2.0) + 8) / std::sqrt(2.0);
}
double floorDepth(double place) {
    return topDepth(place) + 1 / std::sqrt(2.0); // z = -1/2, so x is larger by 1/2
}

Frame exactFrame(const Scene& scene) {
    const ExactPicture picture(scene);
    Frame frame(scene.camera.width, scene.camera.height);
    for (const char* name : {"A", "Z", "uncertain", "shadow.sun", "uncertain.shadow.sun"})
        frame.add(name);
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
            const size_t pixel = static_cast<size_t>(y * frame.width() + x);
            const Vec2 place(x + 0.5, y + 0.5);
            const double depth = picture.depthAt(place);
            if (depth == kInfinity) continue;
            frame.channel("A")[pixel] = 1;
            frame.channel("Z")[pixel] = static_cast<float>(depth);
            frame.channel("shadow.sun")[pixel] = picture.shadowsAt(place)[0] ? 1.0f : 0.0f;
        }
    return frame;
}

class ComparisonOfStep : public testing::Test {
  protected:
    Scene scene = stepScene();
    Frame frame = exactFrame(scene);
    float& pixel(const char* channel, int column) {
        return frame.channel(channel)[static_cast<size_t>(kRow * frame.width() + column)];
    }
    Comparison compare(double jumpRadiusPx) { return compareWithExact(scene, frame, jumpRadiusPx); }
};

TEST(ExactPicture, Step_HidesItsFloor) {
    const Scene scene = stepScene();
    const ExactPicture picture(scene);
    const auto at = [](double place) { return Vec2(place, kRow + 0.5); };
    EXPECT_NEAR(picture.depthAt(at(19.5)), topDepth(19.5), 1e-12);
    EXPECT_NEAR(picture.depthAt(at(20.5)), floorDepth(20.5), 1e-12);
    EXPECT_EQ(picture.depthAt(at(23.6)), kInfinity);
    EXPECT_TRUE(picture.shadowsAt(at(23.6)).empty());
    EXPECT_TRUE(picture.shadowsAt(at(23.4))[0]);
    EXPECT_FALSE(picture.shadowsAt(at(23.5))[0]);
}

TEST(ExactPicture, PixelError_MarksPixelsItCouldChange) {
    const Scene scene = stepScene();
    const ExactPicture picture(scene);
    const auto at = [](double place) { return Vec2(place, kRow + 0.5); };
    EXPECT_TRUE(picture.coverageCouldFlip(at(23.5), 0.036));
    EXPECT_FALSE(picture.coverageCouldFlip(at(23.5), 0.035));
    EXPECT_TRUE(picture.shadowCouldFlip(at(23.4), 0, 0.065));
    EXPECT_FALSE(picture.shadowCouldFlip(at(23.4), 0, 0.064));
    // Column 19 is 0.4293 px before the edge.
    EXPECT_TRUE(picture.depthCouldJumpTo(at(19.5), 0.43, floorDepth(19.5)));
    EXPECT_FALSE(picture.depthCouldJumpTo(at(19.5), 0.42, floorDepth(19.5)));
    EXPECT_FALSE(picture.depthCouldJumpTo(at(19.5), 0.43, floorDepth(19.5) + 2)); // no surface there
    EXPECT_FALSE(picture.depthCouldJumpTo(at(18.0), 1.0, topDepth(18.5))); // it changes, but continuously
}

TEST_F(ComparisonOfStep, ExactFrame_HasNoError) {
    const Comparison same = compare(0);
    EXPECT_EQ(same.pixels, 1600);
    EXPECT_EQ(same.covered, 11 * 20); // columns 13 to 23 of rows 10 to 29
    EXPECT_EQ(same.depthCompared, same.covered);
    EXPECT_EQ(same.shadowCompared, same.covered);
    EXPECT_EQ(same.coverageWrong + same.depthWrong + same.depthJumped + same.shadowWrong, 0);
    EXPECT_LT(same.worstDepth, 6e-8); // float
}

TEST_F(ComparisonOfStep, WrongCoverage_CountsUnlessUncertain) {
    pixel("A", 23) = 0;
    pixel("A", 24) = 1; // 0.9645 px beyond the rim
    EXPECT_EQ(compare(0).coverageWrong, 2);
    EXPECT_EQ(compare(0).coverageBandPx, 1);
    pixel("uncertain", 24) = 1;
    EXPECT_EQ(compare(0).coverageWrong, 1);
    EXPECT_EQ(compare(0).coverageBandPx, 0.0625);
    EXPECT_EQ(compare(0).uncertain, 1);
    EXPECT_EQ(compare(0).firstWrong, std::vector<std::string>{"pixel 23 20: not covered, exactly it is"});
}

TEST_F(ComparisonOfStep, WrongDepth_CountsUnlessAtJump) {
    pixel("Z", 15) *= 1 + 2e-5f;
    pixel("Z", 16) *= 1 + 5e-6f;
    pixel("Z", 19) = static_cast<float>(floorDepth(19.5));
    EXPECT_EQ(compare(0.42).depthWrong, 2);
    EXPECT_EQ(compare(0.43).depthWrong, 1);
    EXPECT_EQ(compare(0.43).depthJumped, 1);
    EXPECT_NEAR(compare(0.43).worstDepth, 5e-6, 2e-7);
    pixel("uncertain", 15) = 1;
    EXPECT_EQ(compare(0.43).depthWrong, 0);
    pixel("Z", 17) = kNanF;
    EXPECT_EQ(compare(0.43).depthWrong, 1);
}

TEST_F(ComparisonOfStep, WrongShadow_CountsUnlessUncertain) {
    pixel("shadow.sun", 15) = 1;
    pixel("shadow.sun", 22) = 0;
    EXPECT_EQ(compare(0).shadowWrong, 2);
    pixel("uncertain.shadow.sun", 22) = 1;
    EXPECT_EQ(compare(0).shadowWrong, 1);
    EXPECT_EQ(compare(0).shadowUncertain, 1);
    pixel("shadow.sun", 18) = kNanF; // missing isn't lit
    EXPECT_EQ(compare(0).shadowWrong, 2);
}

} // namespace
} // namespace plumbline
