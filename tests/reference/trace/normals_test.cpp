// Compares the frame's normals and positions on curved shapes with finite differences of the surface's
// definition and with closed forms.
#include "reference/reference.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/displaced_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

namespace plumbline {
namespace {

SceneObject objectOf(ControlMesh mesh, Relief relief) {
    SceneObject object;
    object.name = mesh.name;
    object.mesh = std::move(mesh);
    object.relief = std::move(relief);
    return object;
}

Scene sceneOf(SceneObject object, const Vec3& cameraPosition, double viewHeight) {
    Scene scene;
    scene.camera.projection = Camera::Projection::Orthographic;
    scene.camera.positionWorld = cameraPosition;
    scene.camera.viewHeight = viewHeight;
    scene.camera.width = scene.camera.height = 96;
    scene.objects.push_back(std::move(object));
    return scene;
}

Relief noiseRelief(double depth, const Vec2& tile) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> depths(16 * 16);
    for (float& d : depths)
        d = uniform(random);
    return {std::make_shared<HeightMap>("noise", 16, 16, depths), depth, 0.02, tile, {0.3, 0.1}};
}

Relief constantRelief(double depth) {
    return {std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f)), depth, 0, {1, 1}, {0, 0}};
}

Frame render(const Scene& scene, int rate) {
    ReferenceOptions options;
    options.rate = rate;
    return ReferenceScene(scene, options).render();
}

struct PixelSample {
    Vec3 position, normal;
    Vec2 st;
};

std::vector<PixelSample> coveredPixels(const Frame& frame) {
    const auto read = [&](const char* name, size_t pixel) { return double(frame.channel(name)[pixel]); };
    std::vector<PixelSample> samples;
    for (size_t i = 0; i < frame.pixelCount(); ++i)
        if (frame.channel("A")[i] == 1)
            samples.push_back({{read("P.X", i), read("P.Y", i), read("P.Z", i)},
                               {read("N.X", i), read("N.Y", i), read("N.Z", i)},
                               {read("st.S", i), read("st.T", i)}});
    return samples;
}

/// Finds the (u,v) of a pixel from its st and position, and computes finite differences of P there.
class SurfaceDifferences {
  public:
    explicit SurfaceDifferences(const SceneObject& object)
        : relief_(*object.relief), surface_(makeBaseSurface(object)), evaluator_(*surface_) {
        for (int patch = 0; patch < static_cast<int>(surface_->patches().size()); ++patch) {
            evaluator_.setPatch(patch);
            const Vec2 corner = evaluator_.point(0, 0).uv;
            const Chart chart{patch, corner, evaluator_.point(1, 0).uv - corner,
                              evaluator_.point(0, 1).uv - corner};
            const Vec2 opposite = corner + chart.alongU + chart.alongV;
            if (glm::length(evaluator_.point(1, 1).uv - opposite) < 1e-12) charts_.push_back(chart);
        }
    }

    /// Unit P_u x P_v by central differences; none where they would cross a patch's border or a crease
    /// between texels, or where the tangent plane is undefined.
    std::optional<Vec3> normalAt(const PixelSample& pixel) {
        // Step in (u,v), and margins to a patch's border and, in texels, to creases. Patches are about 0.2
        // wide with at most 10 texels.
        constexpr double kStep = 1e-5, kPatchMargin = 1e-3, kCreaseMarginTexels = 0.02;
        const Vec2 texel = pixel.st * 16.0 - 0.5;
        const Vec2 toCrease = glm::abs(texel - glm::round(texel));
        if (std::min(toCrease.x, toCrease.y) < kCreaseMarginTexels) return std::nullopt;
        const auto place = placeOf(pixel);
        if (!place || std::min({place->x, place->y, 1 - place->x, 1 - place->y}) < kPatchMargin)
            return std::nullopt;
        const Vec3 byU = point(place->x + kStep, place->y) - point(place->x - kStep, place->y);
        const Vec3 byV = point(place->x, place->y + kStep) - point(place->x, place->y - kStep);
        const Vec3 cross = glm::cross(byU, byV);
        if (glm::length(cross) < 0.05 * glm::length(byU) * glm::length(byV)) return std::nullopt;
        return glm::normalize(cross);
    }

  private:
    struct Chart {
        int patch;
        Vec2 corner, alongU, alongV;
    };

    Vec3 point(double u, double v) const {
        const BasePoint base = evaluator_.point(u, v);
        return base.position + base.normal * displacement(textureCoordinates(base, &relief_), &relief_);
    }

    /// The (u,v) with the pixel's st in the patch that is nearest to its position; sets the evaluator to that
    /// patch.
    std::optional<Vec2> placeOf(const PixelSample& pixel) {
        const Vec2 uv = (pixel.st - relief_.uvOffset) / relief_.tile;
        int nearest = -1;
        Vec2 result;
        double distance = 0.02; // far above the micro-triangles' error, far below the shapes' size
        for (const Chart& chart : charts_) {
            const Vec2 place = glm::inverse(glm::dmat2(chart.alongU, chart.alongV)) * (uv - chart.corner);
            if (std::min({place.x, place.y, 1 - place.x, 1 - place.y}) < 0) continue;
            evaluator_.setPatch(chart.patch);
            const double here = glm::length(point(place.x, place.y) - pixel.position);
            if (here >= distance) continue;
            distance = here;
            nearest = chart.patch;
            result = place;
        }
        if (nearest < 0) return std::nullopt;
        evaluator_.setPatch(nearest);
        return result;
    }

    const Relief& relief_;
    std::unique_ptr<BaseSurface> surface_;
    BaseSurface::Evaluator evaluator_;
    std::vector<Chart> charts_; // of the patches on which uv is affine: all except those at poles
};

// st is a float, accurate to 2^-22 for coordinates up to 8, that is, 4e-6 of a texel. A relief whose normal
// rotates by one or two radians per texel rotates by a few 1e-6 over that. Facet normals of micro-triangles
// deviate by several 1e-2.
constexpr double kSameNormal = 5e-5;

void expectNormalsOfP(const SceneObject& object, const Vec3& cameraPosition, double viewHeight, int rate) {
    const std::vector<PixelSample> pixels =
        coveredPixels(render(sceneOf(object, cameraPosition, viewHeight), rate));
    SurfaceDifferences differences(object);
    size_t compared = 0;
    double worst = 0;
    for (const PixelSample& pixel : pixels)
        if (const auto normal = differences.normalAt(pixel)) {
            worst = std::max(worst, glm::length(*normal - pixel.normal));
            ++compared;
        }
    std::printf("%s: %zu of %zu pixels, worst difference of normals %.1e\n", object.name.c_str(), compared,
                pixels.size(), worst);
    EXPECT_LT(worst, kSameNormal);
    EXPECT_GT(compared, pixels.size() * 3 / 4);
    EXPECT_GT(pixels.size(), 1000u);
}

TEST(Normals, Torus_NormalsAreThoseOfP) {
    expectNormalsOfP(objectOf(makeTorus(1, 0.4, 16, 8), noiseRelief(0.08, {8, 3})), {1, 3, 2}, 3, 64);
}

TEST(Normals, Sphere_NormalsAreThoseOfP) {
    expectNormalsOfP(objectOf(makeSphere(1, 4), noiseRelief(0.08, {2, -2})), {2, 2, 3}, 2.4, 64);
}

TEST(Normals, Teapot_NormalsAreThoseOfP) {
    SceneObject teapot = objectOf(makeTeapot(6), noiseRelief(0.05, {1.37, 1.37}));
    teapot.translate = {0, -1.5, 0};
    expectNormalsOfP(teapot, {1, 2, 4}, 6, 32);
}

/// Deviation of the pixels of a torus or sphere at constant depth from the ideal shape, which is limited by
/// the control mesh.
struct Deviation {
    double position = 0, normal = 0;
};

Deviation torusDeviation(int segments) {
    // A depth of 0.1 * 1/2 below a tube of radius 0.4 around a circle of radius 1 gives a tube of radius
    // 0.35.
    const Scene scene =
        sceneOf(objectOf(makeTorus(1, 0.4, segments, segments), constantRelief(0.1)), {1, 3, 2}, 3);
    Deviation worst;
    for (const PixelSample& pixel : coveredPixels(render(scene, 512 / segments))) {
        const Vec3 p = pixel.position;
        const Vec3 center = Vec3(p.x, 0, p.z) / std::hypot(p.x, p.z);
        const double distance = glm::length(p - center);
        worst.position = std::max(worst.position, std::abs(distance - 0.35));
        worst.normal = std::max(worst.normal, glm::length(pixel.normal - (p - center) / distance));
    }
    return worst;
}

Deviation sphereDeviation(int segments) {
    const Scene scene = sceneOf(objectOf(makeSphere(1, segments), constantRelief(0.1)), {1, 3, 2}, 3);
    Deviation worst;
    for (const PixelSample& pixel : coveredPixels(render(scene, 256 / segments))) {
        worst.position = std::max(worst.position, std::abs(glm::length(pixel.position) - 0.95));
        worst.normal = std::max(worst.normal, glm::length(pixel.normal - glm::normalize(pixel.position)));
    }
    return worst;
}

// With 8 segments, the limit surface of a torus deviates by 0.12 % of each of its two radii, 1.4 and 0.4;
// with 16 segments by a factor of 13.6 less, close to the asymptotic fourth power. Its normals, as a
// derivative, converge with the third power.
TEST(Normals, TorusAtConstantDepth_HasTorusNormals) {
    const Deviation coarse = torusDeviation(8), fine = torusDeviation(16);
    std::printf("torus: off by %.2e at 8 segments, %.2e at 16; normals by %.2e, %.2e\n", coarse.position,
                fine.position, coarse.normal, fine.normal);
    EXPECT_LT(coarse.position, 0.0012 * (1.4 + 0.4));
    EXPECT_LT(fine.position, coarse.position / 12);
    EXPECT_LT(coarse.normal, 0.012); // 0.12 % over a segment of 1.4 * 2 pi / 8, up and down
    EXPECT_LT(fine.normal, coarse.normal / 7);
}

// The sphere deviates by 0.24 % with 4 segments per cube edge, most near the cube's corners, where the
// deviation decreases asymptotically with the second power (2.8 from 4 to 8, 3.6 from 8 to 16) and that of
// normals with the first: 0.02, 0.019, 0.012, 0.007 at 4, 8, 16, 32.
TEST(Normals, SphereAtConstantDepth_HasSphereNormals) {
    const Deviation coarse = sphereDeviation(4), middle = sphereDeviation(8), fine = sphereDeviation(16);
    std::printf("sphere: off by %.2e at 4 segments, %.2e at 8, %.2e at 16; normals by %.2e, %.2e, %.2e\n",
                coarse.position, middle.position, fine.position, coarse.normal, middle.normal, fine.normal);
    EXPECT_LT(coarse.position, 0.0024);
    EXPECT_LT(middle.position, coarse.position / 2.5);
    EXPECT_LT(fine.position, middle.position / 3.3);
    EXPECT_LT(coarse.normal, 0.022);
    EXPECT_LT(fine.normal, middle.normal / 1.4);
}

// z = a x^2 + b y^2 is exact: with (x, y) = 2 uv - 1 and n along (-2 a x, -2 b y, 1), P = S - n / 20. The
// remaining error is that of the micro-triangles, (2 / 1024)^2 / 8 times a curvature of 1.2, and float
// rounding.
TEST(Normals, QuadricAtConstantDepth_HasExactNormals) {
    const double a = 0.6, b = -0.3;
    const Scene scene = sceneOf(objectOf(makeQuadric(a, b, 1, 2), constantRelief(0.1)), {1, 2, 3}, 3);
    const std::vector<PixelSample> pixels = coveredPixels(render(scene, 512));
    double worstPosition = 0, worstNormal = 0;
    for (const PixelSample& pixel : pixels) {
        const Vec2 xy = 2.0 * pixel.st - 1.0;
        const Vec3 normal = glm::normalize(Vec3(-2 * a * xy.x, -2 * b * xy.y, 1));
        const Vec3 position = Vec3(xy, a * xy.x * xy.x + b * xy.y * xy.y) - 0.05 * normal;
        worstPosition = std::max(worstPosition, glm::length(pixel.position - position));
        worstNormal = std::max(worstNormal, glm::length(pixel.normal - normal));
    }
    std::printf("quadric: off by %.2e, normals by %.2e\n", worstPosition, worstNormal);
    EXPECT_GT(pixels.size(), 1000u);
    EXPECT_LT(worstPosition, 2e-6); // 1e-6 of its size
    EXPECT_LT(worstNormal, 2e-6);
}

} // namespace
} // namespace plumbline
