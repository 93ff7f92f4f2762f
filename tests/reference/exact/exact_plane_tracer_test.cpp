// Tests the exact tracer against results derived by hand.
#include "scenes/mesh/shapes/shapes.h"
#include "tests/reference/exact/exact_plane_tracer.h"
#include "tests/reference/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumbline {
namespace {

using MapPointer = std::shared_ptr<const HeightMap>;

// Coordinates are about 1, and a hit takes about a dozen operations with an error of 2^-53 each.
constexpr double kRounding = 1e-13;

MapPointer clampedMap(int width, int height, std::vector<float> depths) {
    return std::make_shared<HeightMap>("by hand", width, height, std::move(depths), Wrap::Clamp, Wrap::Clamp);
}

ExactPlaneTracer squareTracer(MapPointer map, double depth) {
    return ExactPlaneTracer(flatRelief(squareScene(std::move(map), depth).objects[0]));
}

Ray rayFrom(const Vec3& origin, const Vec3& direction) {
    return {origin, glm::normalize(direction)};
}

void expectHit(const ExactPlaneTracer& tracer, const Ray& ray, const Vec3& position, const Vec3& normal,
               double tolerance = kRounding) {
    const auto hit = tracer.trace(ray);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, glm::length(position - ray.origin), tolerance);
    EXPECT_LT(glm::length(hit->position - position), tolerance);
    EXPECT_LT(glm::length(hit->normal - glm::normalize(normal)), tolerance);
    const Vec2 st = (Vec2(position) + 1.0) / 2.0; // of the square of side 2, untiled
    EXPECT_LT(glm::length(hit->st - st), tolerance);
}

TEST(ExactQuadratic, Roots_AreOrderedWithinInterval) {
    // (x - 1)(x - 3) = x^2 - 4x + 3.
    EXPECT_EQ(firstRootOfQuadratic(1, -2, 3, 10), 1.0);
    EXPECT_EQ(firstRootOfQuadratic(-1, 2, -3, 10), 1.0);
    EXPECT_EQ(firstRootOfQuadratic(1, -2, 3, 0.5), std::nullopt);
    EXPECT_EQ(firstRootOfQuadratic(1, -1, -3, 10), 3.0); // (x + 1)(x - 3)
    EXPECT_EQ(firstRootOfQuadratic(1, -1, 1, 10), 1.0);  // (x - 1)^2
    EXPECT_EQ(firstRootOfQuadratic(1, -1, 1.0000001, 10), std::nullopt);
    EXPECT_EQ(firstRootOfQuadratic(0, 1, -4, 10), 2.0);         // 2x - 4
    EXPECT_EQ(firstRootOfQuadratic(0, 0, 1, 10), std::nullopt); // never
    EXPECT_EQ(firstRootOfQuadratic(0, 0, 0, 10), 0.0);          // everywhere
    // 1e-8 x^2 + 2x - 1: the small root is 1/2 - 1e-8/8 + ..., lost by the textbook formula's difference of
    // two numbers near 2.
    EXPECT_NEAR(*firstRootOfQuadratic(1e-8, 1, -1, 1), 0.5 - 1.25e-9, 1e-16);
}

// The surface is the plane z = -0.125. A ray from (-3, 0.2, 1) along (2, 0, -1) reaches it after descending
// 1.125, so 2.25 across.
TEST(ExactPlane, ConstantDepth_IsExact) {
    const ExactPlaneTracer tracer = squareTracer(clampedMap(1, 1, {0.5f}), 0.25);
    expectHit(tracer, rayFrom({0.3, 0.2, 5}, {0, 0, -1}), {0.3, 0.2, -0.125}, {0, 0, 1});
    expectHit(tracer, rayFrom({0.3, 0.2, -5}, {0, 0, 1}), {0.3, 0.2, -0.125}, {0, 0, 1}); // its underside
    expectHit(tracer, rayFrom({-3, 0.2, 1}, {2, 0, -1}), {-0.75, 0.2, -0.125}, {0, 0, 1});
    EXPECT_NEAR(tracer.trace(rayFrom({-3, 0.2, 1}, {2, 0, -1}))->crossing, 1 / std::sqrt(5.0), kRounding);
    EXPECT_FALSE(tracer.trace(rayFrom({0.3, 1.001, 5}, {0, 0, -1})));
    EXPECT_FALSE(tracer.trace(rayFrom({1.001, 0.2, 5}, {0, 0, -1}))); // beside it
    EXPECT_FALSE(tracer.trace(rayFrom({0.3, 0.2, 5}, {0, 0, 1})));    // away from it
    EXPECT_FALSE(tracer.trace(
        rayFrom({-3, 0.2, -0.06}, {1, 0, 0}))); // between base and relief: no wall at the boundary
    EXPECT_FALSE(tracer.occluded({0.3, 0.2, 5}, {0, 0, -1}, 5.1249)); // it starts at 5.125
    EXPECT_TRUE(tracer.occluded({0.3, 0.2, 5}, {0, 0, -1}, 5.1251));
    // For a ray in the plane, every point of the sheet is a root; the first one is on its boundary.
    const auto along = tracer.trace(rayFrom({-3, 0.25, -0.125}, {1, 0, 0}));
    ASSERT_TRUE(along);
    EXPECT_EQ(along->distance, 2);
    EXPECT_EQ(along->crossing, 0);
}

// d = 2 s - 1/2 between the texel centers of two texels, x = 2 s - 1: z = -(x + 1/2) for |x| <= 1/2. A ray
// through
// (-1/2, 1/2) in (x, z) that falls 2 a unit of x meets it where 1/2 - 2 r = -r: r = 1/2, at (0, -1/2).
TEST(ExactPlane, Ramp_IsExact) {
    const ExactPlaneTracer tracer = squareTracer(clampedMap(2, 1, {0, 1}), 1);
    expectHit(tracer, rayFrom({-0.5, 0.3, 0.5}, {1, 0, -2}), {0, 0.3, -0.5}, {1, 0, 1});
    expectHit(tracer, rayFrom({0, 0.3, -3}, {0, 0, 1}), {0, 0.3, -0.5}, {1, 0, 1});
    expectHit(tracer, rayFrom({0.8, 0.3, 5}, {0, 0, -1}), {0.8, 0.3, -1}, {0, 0, 1});
    // Inside the layer, parallel to the plane: from the right over the floor into the slope at z = -3/4.
    expectHit(tracer, rayFrom({0.9, -0.4, -0.75}, {-1, 0, 0}), {0.25, -0.4, -0.75}, {1, 0, 1});
    // The same from outside, entering above the floor's boundary.
    expectHit(tracer, rayFrom({3, -0.4, -0.75}, {-1, 0, 0}), {0.25, -0.4, -0.75}, {1, 0, 1});
    // From the left: below the top, onto the slope's back side.
    expectHit(tracer, rayFrom({-3, -0.4, -0.75}, {1, 0, 0}), {0.25, -0.4, -0.75}, {1, 0, 1});
}

// Texels 0 1 / 1 0 with centers at x, y = +-1/2. With p = x + 1/2, q = y + 1/2 in [0,1] the one cell between
// them has d = p (1 - q) + q (1 - p) = p + q - 2 p q, and z = -d at depth 1. Along the diagonal p = q = r: z
// = -(2 r - 2 r^2). Beyond the corners of the cell, clamped: z = 0 along the diagonal. By p: z_x = -(1 - 2
// q), z_y = -(1 - 2 p), so the normal is (1 - 2 q, 1 - 2 p, 1).
TEST(ExactPlane, SaddleOfOneCell_IsExact) {
    const ExactPlaneTracer tracer = squareTracer(clampedMap(2, 2, {0, 1, 1, 0}), 1);
    // p = 1/4, q = 3/4: d = 1 - 3/8 = 5/8.
    expectHit(tracer, rayFrom({-0.25, 0.25, 4}, {0, 0, -1}), {-0.25, 0.25, -0.625}, {-0.5, 0.5, 1});
    // At height -3/8 along the diagonal: 2 r^2 - 2 r + 3/8 = 0, r = 1/4 and 3/4. From the outside the first,
    // from below (z = 0 out there); from the middle the second, from above.
    expectHit(tracer, rayFrom({-2, -2, -0.375}, {1, 1, 0}), {-0.25, -0.25, -0.375}, {0.5, 0.5, 1});
    expectHit(tracer, rayFrom({0, 0, -0.375}, {1, 1, 0}), {0.25, 0.25, -0.375}, {-0.5, -0.5, 1});
    // Slanted: z = 1/8 - r along the diagonal meets it where 2 r^2 - 2 r = 1/8 - r, so r = (1 + sqrt 2) / 4.
    const double r = (1 + std::sqrt(2.0)) / 4;
    expectHit(tracer, rayFrom({-0.5, -0.5, 0.125}, {1, 1, -1}), {r - 0.5, r - 0.5, 0.125 - r},
              {1 - 2 * r, 1 - 2 * r, 1});
}

// The valley's lowest point on that diagonal is r = 1/2, z = -1/2. A ray e above it, from the outside and
// below the surface, meets 2 r^2 - 2 r + 1/2 = e at r = 1/2 - sqrt(e / 2); e below it passes underneath and
// out. An error of a few 2^-53 in e moves the root by (1e-16 / 2) / sqrt(2 e).
TEST(ExactPlane, TangentRays_AreExact) {
    const ExactPlaneTracer tracer = squareTracer(clampedMap(2, 2, {0, 1, 1, 0}), 1);
    for (const double e : {1e-2, 1e-6, 1e-9, 1e-12}) {
        SCOPED_TRACE(e);
        const double x = -std::sqrt(e / 2);
        const double tolerance = kRounding + 4e-16 / std::sqrt(e);
        expectHit(tracer, rayFrom({-2, -2, -0.5 + e}, {1, 1, 0}), {x, x, -0.5 + e}, {-2 * x, -2 * x, 1},
                  tolerance);
        // N . direction = (-2x - 2x) / sqrt 2 over |N| = sqrt(8 x^2 + 1).
        EXPECT_NEAR(tracer.trace(rayFrom({-2, -2, -0.5 + e}, {1, 1, 0}))->crossing,
                    -4 * x / std::sqrt(2 * (8 * x * x + 1)), 4 * tolerance);
        EXPECT_FALSE(tracer.trace(rayFrom({-2, -2, -0.5 - e}, {1, 1, 0})));
    }
}

// 5 x 5 texels of depth 1 but for the middle one, 0: texels are 0.4 wide and the tip stands at the origin,
// depth 1. Around it d = 1 - (1 - |x| / 0.4)(1 - |y| / 0.4) for |x|, |y| < 0.4.
TEST(ExactPlane, Needle_IsFound) {
    std::vector<float> depths(25, 1.0f);
    depths[12] = 0;
    const ExactPlaneTracer tracer = squareTracer(clampedMap(5, 5, depths), 1);
    // Along y = 0, a border of cells: z = 2.5 x left of the tip; the ray z = -(x + 1) / 4 meets it at x =
    // -1/11. The cell above is meant: the gradient of a crease is that of the patch to the right and above.
    // Its normal: z_x = 2.5, z_y = -(1 - |x| / 0.4) / 0.4 = -2.5 (1 - 2.5 / 11).
    expectHit(tracer, rayFrom({-1, 0, 0}, {1, 0, -0.25}), {-1.0 / 11, 0, -2.5 / 11},
              {-2.5, 2.5 * (1 - 2.5 / 11), 1});
    // Along y = 0.1: z = -1 + 0.75 (1 + 2.5 x) = -0.25 + 1.875 x; the ray z = -(x + 1) / 2 meets it at x =
    // -2/19. z_x = 1.875, z_y = -2.5 (1 - 5/19).
    expectHit(tracer, rayFrom({-1, 0.1, 0}, {1, 0, -0.5}), {-2.0 / 19, 0.1, -17.0 / 38},
              {-1.875, 2.5 * 14 / 19, 1});
    // Straight onto the tip; past it in every direction, e above, and through it e below.
    EXPECT_NEAR(tracer.trace(rayFrom({0, 0, 5}, {0, 0, -1}))->distance, 5, kRounding);
    for (int k = 0; k < 16; ++k) {
        const Vec3 across(std::cos(k * kPi / 8), std::sin(k * kPi / 8), 0);
        EXPECT_FALSE(tracer.trace(rayFrom(-2.0 * across + Vec3(0, 0, 1e-12), across))) << k;
        EXPECT_TRUE(tracer.trace(rayFrom(-0.99 * across + Vec3(0, 0, -1e-12), across))) << k;
    }
}

TEST(ExactPlane, RaysThroughTexelCenters_AreExact) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> depth(0, 1);
    std::vector<float> depths(8 * 8);
    for (float& d : depths)
        d = depth(random);
    const ExactPlaneTracer tracer = squareTracer(clampedMap(8, 8, depths), 0.5);
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i) {
            const Vec3 center((i + 0.5) / 4 - 1, (j + 0.5) / 4 - 1,
                              -0.5 * depths[static_cast<size_t>(8 * j + i)]);
            for (const double side : {1.0, -1.0})
                for (int k = 0; k < 9;
                     ++k) { // steeper than any slope: 0.5 over a texel of 0.25, in both directions
                    const Vec3 direction(0.2 * (k % 3 - 1), 0.2 * (k / 3 - 1), -side);
                    const auto hit = tracer.trace(rayFrom(center - 3.0 * direction, direction));
                    ASSERT_TRUE(hit) << i << " " << j << " " << k;
                    EXPECT_LT(glm::length(hit->position - center), kRounding) << i << " " << j << " " << k;
                }
        }
}

// The ramp z = -(x + 1/2) under a light toward (-1, 0, 1), a hair flatter. The top sees it; the slope,
// normal (1, 0, 1), turns away by the hair. From the floor at x = 3/4 the ray rises 1 a unit and is over the
// edge of the top, x = -1/2, at height -1 + 5/4 > 0: lit. At depth 2 the floor lies at -2: dark, but not for
// a light that ends before the slope, at x = 1/2.
TEST(ExactPlane, Shadows_AreExact) {
    const Vec3 up(0, 0, 1), down(0, 0, -1);
    const LightSample light{glm::normalize(Vec3(-1.001, 0, 1)), kInfinity};
    const auto shadowAt = [&](double depth, double x, const Vec3& toCamera, const LightSample& sample) {
        const ExactPlaneTracer tracer = squareTracer(clampedMap(2, 1, {0, 1}), depth);
        return tracer.shadowed(*tracer.trace({Vec3(x, 0.3, 0) + 5.0 * toCamera, -toCamera}), toCamera,
                               sample);
    };
    EXPECT_FALSE(shadowAt(1, -0.75, up, light));
    EXPECT_TRUE(shadowAt(1, 0, up, light));
    EXPECT_FALSE(shadowAt(1, 0.75, up, light));
    EXPECT_TRUE(shadowAt(2, 0.75, up, light));
    EXPECT_FALSE(shadowAt(2, 0.75, up, {light.toLightWorld, 0.25}));
    // The slope's back faces that light by the hair, but the ray then meets the top's underside, half a unit
    // up at x = -0.5005; a flatter one leaves over the rim, at (-1, -0.3). The floor's underside turns away.
    EXPECT_TRUE(shadowAt(1, 0, down, light));
    EXPECT_FALSE(shadowAt(1, 0, down, {glm::normalize(Vec3(-1, 0, 0.2)), kInfinity}));
    EXPECT_TRUE(shadowAt(1, 0.75, down, light));
    EXPECT_FALSE(shadowAt(1, 0.75, down, {glm::normalize(Vec3(-1, 0, -1)), kInfinity}));
}

TEST(ExactPlane, SceneShapes_AreFlatReliefs) {
    SceneObject object = squareScene(clampedMap(2, 1, {0, 1}), 1).objects[0];
    object.mesh = makePlane(3, 2, 4, 5);
    object.rotateDegrees = {20, -30, 40};
    object.translate = {1, 2, 3};
    object.scale = 0.5;
    const FlatRelief plane = flatRelief(object);
    EXPECT_NEAR(glm::length(plane.edgeU), 1.5, kRounding);
    EXPECT_NEAR(glm::length(plane.edgeV), 1.0, kRounding);
    EXPECT_LT(glm::length(plane.normal - Vec3(worldFromObject(object) * Vec4(0, 1, 0, 0)) / 0.5), kRounding);
    object.mesh.points[7].y += 1e-6;
    EXPECT_THROW(flatRelief(object), std::invalid_argument);
}

} // namespace
} // namespace plumbline
