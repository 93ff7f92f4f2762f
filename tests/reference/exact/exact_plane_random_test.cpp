// Compares the exact tracer with ray marching in very small steps, on random maps, tiles and rays, and in
// numerically difficult cases.
#include "scenes/surface/displaced_surface.h"
#include "tests/reference/exact/exact_plane_tracer.h"
#include "tests/reference/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

namespace plumbline {
namespace {

Ray rayFrom(const Vec3& origin, const Vec3& direction) {
    return {origin, glm::normalize(direction)};
}

/// Height of a world point above the relief, computed only from the scene's definitions; NaN outside the
/// rectangle.
class HeightOver {
  public:
    explicit HeightOver(const FlatRelief& plane)
        : plane_(plane), fromWorld_(glm::inverse(Mat3(plane.edgeU, plane.edgeV, plane.normal))) {}
    double operator()(const Vec3& point) const {
        const Vec3 place = fromWorld_ * (point - plane_.corner);
        if (place.x < 0 || place.x > 1 || place.y < 0 || place.y > 1) return std::nan("");
        const Vec2 uv = plane_.uvCorner + place.x * plane_.uvAlongU + place.y * plane_.uvAlongV;
        return place.z - displacement(plane_.relief.tile * uv + plane_.relief.uvOffset, &plane_.relief);
    }
    /// Unit gradient, by central differences: the normal of the surface.
    Vec3 gradient(const Vec3& point, double step) const {
        Vec3 result;
        for (int k = 0; k < 3; ++k) {
            Vec3 along(0);
            along[k] = step;
            result[k] = (*this)(point + along) - (*this)(point - along);
        }
        return glm::normalize(result);
    }

  private:
    const FlatRelief& plane_;
    Mat3 fromWorld_;
};

/// First change of sign over `steps` steps, then bisection to the last bit.
std::optional<double> marchToHit(const HeightOver& height, const Ray& ray, double end, int steps) {
    double previous = height(ray.origin);
    for (int k = 1; k <= steps; ++k) {
        const double now = height(ray.at(end * k / steps));
        if (previous * now <= 0) { // false for NaN
            double low = end * (k - 1) / steps, high = end * k / steps;
            for (int halving = 0; halving < 60; ++halving) {
                const double middle = (low + high) / 2;
                (previous * height(ray.at(middle)) <= 0 ? high : low) = middle;
            }
            return high;
        }
        previous = now;
    }
    return std::nullopt;
}

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

double pick(Random& random, const std::vector<double>& values) {
    return values[random() % values.size()];
}

FlatRelief randomPlane(Random& random) {
    const int width = 1 + static_cast<int>(random() % 9), rows = 1 + static_cast<int>(random() % 9);
    const bool spikes = random() % 2 == 0;
    std::vector<float> depths(static_cast<size_t>(width * rows));
    for (float& d : depths)
        d = spikes ? (random() % 6 == 0 ? 0.0f : 1.0f) : static_cast<float>(uniform(random, 0, 1));
    const auto wrap = [&] { return random() % 2 ? Wrap::Repeat : Wrap::Clamp; };
    SceneObject object = squareScene(nullptr, 0).objects[0];
    if (random() % 2)
        for (Vec2& uv : object.mesh.uvs)
            uv.x = 1 - uv.x; // mirrored, so u x v points inward
    object.rotateDegrees = {uniform(random, -180, 180), uniform(random, -90, 90), uniform(random, -180, 180)};
    object.translate = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    const Wrap wrapS = wrap(), wrapT = wrap();
    Relief relief;
    relief.map = std::make_shared<HeightMap>("random", width, rows, depths, wrapS, wrapT);
    relief.depth = pick(random, {0.02, 0.1, 0.5, 2});
    relief.offset = uniform(random, -0.2, 0.2);
    relief.tile = {pick(random, {1, 1.37, -1, -2.5, 3, 0.3}), pick(random, {1, 1.37, -1, 8, 0.7})};
    relief.uvOffset = {pick(random, {0, 0.5, -0.31, 17.2}), pick(random, {0, -3.3, 0.25})};
    object.relief = relief;
    return flatRelief(object);
}

/// A ray from a random origin toward a point in the layer; a third of the rays are at grazing angles.
Ray randomRay(Random& random, const FlatRelief& plane) {
    const auto place = [&](double height) {
        return plane.corner + uniform(random, -0.2, 1.2) * plane.edgeU +
               uniform(random, -0.2, 1.2) * plane.edgeV + height * plane.normal;
    };
    const double tilt = pick(random, {1, 1, 1, 0.1, 0.001, 0});
    const double height = plane.relief.offset - uniform(random, 0, plane.relief.depth);
    const Vec3 through = place(height), origin = place(height + tilt * uniform(random, -2, 2));
    return rayFrom(origin, through - origin);
}

/// Whether a point is within this many texels of a crease between patches, where the normal is undefined.
bool nearCrease(const FlatRelief& plane, const Vec2& st, double texels) {
    const Vec2 x = st * Vec2(plane.relief.map->width(), plane.relief.map->height()) - 0.5;
    const Vec2 away = glm::abs(x - glm::round(x));
    return std::min(away.x, away.y) <= texels;
}

TEST(ExactPlane, RandomRays_AgreeWithMarching) {
    constexpr int kCases = 600, kSteps = 100000;
    constexpr double kReach = 8;
    // Relative to the distance. Heights are accurate to 2^-50, so a root crossed at a sine above 1e-6 is more
    // accurate than this.
    constexpr double kSame = 1e-9;
    // Central differences over 2e-6: patches are at most quadratic, heights rounded to 1e-15.
    constexpr double kStep = 1e-6, kSameNormal = 1e-7;
    int hits = 0, normals = 0, steppedOver = 0;
    for (unsigned seed = 0; seed < kCases; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const FlatRelief plane = randomPlane(random);
        const Ray ray = randomRay(random, plane);
        const HeightOver height(plane);
        const auto exact = ExactPlaneTracer(plane).trace(ray, kReach);
        const auto marched = marchToHit(height, ray, kReach, kSteps);
        if (!exact && !marched) continue;
        ASSERT_TRUE(exact) << "marching finds a hit at " << *marched;
        ++hits;
        EXPECT_LT(std::abs(height(exact->position)), 1e-13 * (1 + plane.relief.depth));
        if (!nearCrease(plane, exact->st, 1e-3) && std::isfinite(height.gradient(exact->position, kStep).x)) {
            EXPECT_LT(glm::length(exact->normal - height.gradient(exact->position, kStep)), kSameNormal);
            ++normals;
        }
        if (marched && std::abs(exact->distance - *marched) <= kSame * *marched) continue;
        // Marching may step over two roots at once, or over one near the boundary; then the tracer's hit is
        // nearer.
        if (marched) {
            EXPECT_LT(exact->distance, *marched);
        }
        ++steppedOver;
    }
    std::printf("%d of %d rays hit, %d with a normal; marching stepped over %d of these hits\n", hits, kCases,
                normals, steppedOver);
    EXPECT_GT(hits, kCases / 3);
    EXPECT_GT(normals, hits / 2);
    EXPECT_LE(steppedOver, kCases / 100);
}

/// The point (a,b) moved to the nearest crease along s; if `both`, also along t, that is, to the nearest
/// texel center.
Vec2 movedToCrease(const FlatRelief& plane, const Vec2& ab, bool both) {
    const Vec2 mapSize(plane.relief.map->width(), plane.relief.map->height());
    const Vec2 uvEdges(plane.uvAlongU.x, plane.uvAlongV.y); // the others are 0
    const Vec2 texel =
        (plane.relief.tile * (plane.uvCorner + ab * uvEdges) + plane.relief.uvOffset) * mapSize - 0.5;
    const Vec2 moved = ab + (glm::round(texel) - texel) / (plane.relief.tile * uvEdges * mapSize);
    return {moved.x, both ? moved.y : ab.y};
}

// A ray that starts above the layer and ends below it, both within the rectangle, can't miss. No root may be
// lost to rounding, especially on borders between cells, so every second ray is aimed at a crease and every
// fourth at a texel center.
TEST(ExactPlane, RandomRays_NeverPassSheet) {
    constexpr int kPlanes = 300, kRays = 500;
    for (unsigned seed = 0; seed < kPlanes; ++seed) {
        Random random(seed);
        const FlatRelief plane = randomPlane(random);
        const ExactPlaneTracer tracer(plane);
        const HeightOver height(plane);
        for (int k = 0; k < kRays; ++k) {
            Vec2 ab(uniform(random, 0.1, 0.9), uniform(random, 0.1, 0.9));
            const Vec2 onCrease = movedToCrease(plane, ab, k % 4 == 0);
            if (k % 2 == 0 && glm::length(onCrease - 0.5) < 0.4) ab = onCrease;
            Vec3 target = plane.corner + ab.x * plane.edgeU + ab.y * plane.edgeV;
            target -= height(target) * plane.normal; // onto the surface
            Vec3 through = 1.01 * plane.relief.depth * plane.normal;
            if (k % 3 != 0) // otherwise vertical
                through +=
                    uniform(random, -0.05, 0.05) * plane.edgeU + uniform(random, -0.05, 0.05) * plane.edgeV;
            if (k % 5 < 2) through = -through;
            const auto hit = tracer.trace(rayFrom(target - through, through), 2 * glm::length(through));
            ASSERT_TRUE(hit) << "seed " << seed << ", ray " << k;
            ASSERT_LT(std::abs(height(hit->position)), 1e-13 * (1 + plane.relief.depth))
                << "seed " << seed << ", ray " << k;
        }
    }
}

// Rays along the borders between cells, or through many of their corners, in both directions, which are the
// most difficult cases for a traversal of cells. Side 2 and 8 texels: centers at (i + 1/2) / 4 - 1.
TEST(ExactPlane, RaysOnCellBordersAndCorners_AreExact) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> depth(0, 1);
    std::vector<float> depths(8 * 8);
    for (float& d : depths)
        d = depth(random);
    const auto map = std::make_shared<HeightMap>("noise", 8, 8, depths);
    const ExactPlaneTracer tracer(flatRelief(squareScene(map, 1).objects[0]));
    int hits = 0;
    for (int k = 0; k < 8; ++k)
        for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                      Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(1, -1, 0)})
            for (const double fall : {0.0, 0.1, 0.5, -0.3}) {
                SCOPED_TRACE(testing::Message() << "texel " << k << ", direction " << direction.x << " "
                                                << direction.y << ", fall " << fall);
                const Vec3 center((k + 0.5) / 4 - 1, (2 + 0.5) / 4 - 1, -0.6);
                const Vec3 along(direction.x, direction.y, -fall);
                const Ray ray = rayFrom(center - 2.0 * along, along);
                const auto exact = tracer.trace(ray);
                const auto marched = marchToHit(HeightOver(tracer.plane()), ray, 8, 100000);
                ASSERT_EQ(exact.has_value(), marched.has_value());
                if (!exact) continue;
                EXPECT_NEAR(exact->distance, *marched, 1e-11);
                ++hits;
            }
    EXPECT_GT(hits, 100);
}

} // namespace
} // namespace plumbline
