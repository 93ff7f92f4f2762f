// Parallax mapping with slope information, on planar reliefs.
#include "tests/realtime/gl_fixture.h"

#include <cmath>
#include <functional>

namespace plumbline {
namespace {

constexpr int kPixels = 16;
// The relief's depth is linear over its map of 64 x 64 texels, between the centers of the outermost texels.
constexpr double kDepthAtCorner = 0.1, kSlopeS = 0.5, kSlopeT = 0.3;

std::shared_ptr<const HeightMap> slopingMap() {
    std::vector<float> depths;
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            depths.push_back(
                static_cast<float>(kDepthAtCorner + kSlopeS * (i + 0.5) / 64 + kSlopeT * (j + 0.5) / 64));
    return std::make_shared<HeightMap>("slope", 64, 64, std::move(depths), Wrap::Clamp, Wrap::Clamp);
}

/// A ray on the square, 2 wide, and the relief's plane with its depth multiplied by `scale`.
struct PlaneCase {
    double depth0;    // below the fragment
    double rise;      // change of the depth from t = 0 to 1: grad D . stTravel
    double cosine;    // between ray and polygon's normal
    double normalOut; // of the relief's unit normal, along the polygon's
    /// n . E, by the identity n . E = (1 - rise) n_z cosine.
    double facing() const { return (1 - rise) * normalOut * cosine; }
};

/// Draws a square of `depth` seen at `angle` degrees from its normal and calls `check` with every pixel's
/// case and its hit's t.
void forEachPixel(const std::string& technique, double angle, double turn, double depth, double scale,
                  const std::function<void(const PlaneCase&, double)>& check) {
    const double a = radians(angle), b = radians(turn);
    const Vec3 towardEye(-std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
    const Camera camera = orthographicCamera(5.0 * towardEye, {0, 1, 0.1}, 0.1, kPixels);
    const CameraRays rays(camera);
    const Frame frame = draw(sceneOf(squareObject(2, slopingMap(), depth), camera), technique);
    const double slopeX = scale * kSlopeS * depth / 2, slopeY = scale * kSlopeT * depth / 2;
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const Ray ray = rays.ray(x + 0.5, y + 0.5);
            const Vec3 entry = ray.at(-ray.origin.y / ray.direction.y);
            const Vec3 travel = ray.direction * (depth / -ray.direction.y);
            PlaneCase plane;
            plane.depth0 =
                scale * (kDepthAtCorner + kSlopeS * (entry.x + 1) / 2 + kSlopeT * (1 - entry.z) / 2);
            plane.rise = scale * (kSlopeS * travel.x - kSlopeT * travel.z) / 2;
            plane.cosine = -ray.direction.y;
            plane.normalOut = 1 / std::sqrt(1 + slopeX * slopeX + slopeY * slopeY);
            check(plane, -vectorAt(frame, "P", pixelAt(frame, x, y)).y / depth);
        }
}

// For float positions 5 units from the eye, relative to a depth of at least 0.3.
constexpr double kTolerance = 1e-5;

TEST(SlopeParallax, Plane_IsHitExactly) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const double turn : {0.0, 130.0, 250.0}) // downhill, uphill, across
        for (const double scale : {1.0, 0.4})
            forEachPixel("parallax_slope_exact:scale=" + std::to_string(scale), 50, turn, 0.5, scale,
                         [&](const PlaneCase& plane, double t) {
                             ASSERT_NEAR(t, plane.depth0 / (1 - plane.rise), kTolerance) << turn;
                         });
}

TEST(SlopeParallax, SafeForm_OmitsDivision) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const double turn : {0.0, 130.0, 250.0})
        for (const double scale : {1.0, 0.4})
            forEachPixel("parallax_slope:scale=" + std::to_string(scale), 50, turn, 0.5, scale,
                         [&](const PlaneCase& plane, double t) {
                             ASSERT_NEAR(t, plane.depth0 * plane.normalOut * plane.cosine, kTolerance);
                         });
}

TEST(SlopeParallax, BackFacingPlane_IsHitBySafeForm) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // 2 deep and 2 wide, seen at 80 degrees: the plane descends faster than the ray.
    forEachPixel("parallax_slope_exact", 80, 0, 2, 1, [](const PlaneCase& plane, double t) {
        ASSERT_LT(plane.facing(), 0);
        ASSERT_NEAR(t, plane.depth0 * plane.normalOut * plane.cosine, kTolerance);
    });
}

TEST(SlopeParallax, PrintedCode_MissesNormalScale) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // E7: the plane scaled by 0.4 is intersected as if it had the slope of the stored one.
    forEachPixel("parallax_slope_exact:rescale_normal=false,scale=0.4", 50, 0, 0.5, 0.4,
                 [](const PlaneCase& plane, double t) {
                     ASSERT_NEAR(t, plane.depth0 / (1 - plane.rise / 0.4), kTolerance);
                     ASSERT_GT(std::abs(t - plane.depth0 / (1 - plane.rise)), 0.01);
                 });
}

TEST(IterativeParallax, EachIteration_LeavesOneMinusCosine) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // E8: at t = 0 the error is the distance to the hit; each iteration multiplies it by (1 - n . E).
    for (const double turn : {0.0, 130.0})
        for (const int rounds : {0, 1, 2, 4, 9})
            forEachPixel("parallax_iterative:iterations=" + std::to_string(rounds), 50, turn, 0.5, 1,
                         [&](const PlaneCase& plane, double t) {
                             const double hit = plane.depth0 / (1 - plane.rise);
                             ASSERT_NEAR(t, hit * (1 - std::pow(1 - plane.facing(), rounds)), kTolerance);
                         });
}

TEST(IterativeParallax, UndampedOnPlane_HitsInOneIteration) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const char* technique :
         {"parallax_iterative:damping=none,iterations=1", "parallax_iterative:damping=none"})
        forEachPixel(technique, 50, 130, 0.5, 1, [](const PlaneCase& plane, double t) {
            ASSERT_NEAR(t, plane.depth0 / (1 - plane.rise), kTolerance);
        });
}

TEST(IterativeParallax, EachIteration_CostsOneBakedLookUp) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Camera camera = orthographicCamera({-3, 4, 0}, {0, 1, 0}, 0.1, kPixels);
    for (const auto& [technique, lookups, iterations] :
         {std::tuple("parallax_iterative", 4, 4), {"parallax_slope", 1, 0}, {"parallax_slope_exact", 1, 0}}) {
        const Frame frame = draw(sceneOf(squareObject(2, slopingMap(), 0.5), camera), technique);
        EXPECT_EQ(frame.channel("cost.fetches")[pixelAt(frame, 8, 8)], lookups) << technique;
        EXPECT_EQ(frame.channel("cost.iterations")[pixelAt(frame, 8, 8)], iterations) << technique;
    }
}

} // namespace
} // namespace plumbline
