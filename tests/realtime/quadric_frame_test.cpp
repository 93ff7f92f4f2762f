// Outlines over bent bases against the closed form of the quadric model.
#include "gl_fixture.h"

#include <cmath>

namespace plumbline {
namespace {

constexpr int kPixels = 512;

/// Around Y, radius 1, 256 sides, a relief of constant relief depth `d`, depth `depth`.
Scene cylinderScene(float d, double depth) {
    SceneObject object;
    object.name = "cylinder";
    object.mesh = makeCylinder(1, 2, 256, 4);
    object.scheme = Scheme::None;
    object.relief = Relief{std::make_shared<HeightMap>(HeightMap::constant("constant", d)), depth, 0,
                           Vec2(6, 2), Vec2(0)};
    return sceneOf(object, orthographicCamera({0, 0, 5}, {0, 1, 0}, 2.4, kPixels));
}

/// Half of the covered width of the middle row, world units.
double halfWidth(const Frame& frame) {
    int covered = 0;
    for (int x = 0; x < kPixels; ++x)
        covered += frame.channel("A")[pixelAt(frame, x, kPixels / 2)] > 0;
    return 0.5 * covered * 2.4 / kPixels;
}

TEST(QuadricOutline, OfACylinderIsThatOfItsOsculatingParabola) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Fragment at angle a from the viewing direction: v_d = cos a / h, f = sin^2 a / (2 R h) for a relief h deep. The ray
    // gets no deeper than v_d^2 / (4 f) = R cos^2 a / (2 h sin^2 a); it meets the depth D if that is >= D, so the outline
    // is at sin a = 1 / sqrt(1 + 2 D h / R) (the true one, of the radius R - D h, is at 1 - D h / R). Errors: one pixel
    // (0.0047) of the outline, the linear search (1000 steps: D is passed only for an instant there, 1e-3 of the way).
    for (const auto& [d, depth] : {std::pair(0.5f, 0.2), std::pair(1.0f, 0.1), std::pair(0.25f, 0.6)}) {
        const Frame frame = draw(cylinderScene(d, depth), "linear_binary@quadric:linear_steps=1000");
        const double expected = 1 / std::sqrt(1 + 2 * d * depth);
        EXPECT_NEAR(halfWidth(frame), expected, 0.005) << d << " " << depth;
        // On the flat surface the outline is the polygon's.
        EXPECT_NEAR(halfWidth(draw(cylinderScene(d, depth), "linear_binary")), 1, 0.003);
    }
}

TEST(QuadricFrame, PositionsLieOnTheParabolaUnderTheFragment) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const double d = 0.5, h = 0.2;
    const Frame frame =
        draw(cylinderScene(0.5f, h), "linear_binary@quadric:linear_steps=1000,binary_steps=16");
    size_t compared = 0;
    for (int x = 20; x < kPixels; x += 7) {
        const size_t pixel = pixelAt(frame, x, kPixels / 2);
        if (frame.channel("A")[pixel] == 0) continue;
        // sin a = x / R; along the ray d(tau) = (cos a tau - sin^2 a tau^2 / 2) / h = D, so
        // tau = 2 D h / (cos a + sqrt(cos^2 a - 2 sin^2 a D h)), and z = cos a - tau.
        const double sine = (x + 0.5) * 2.4 / kPixels - 1.2, cosine = std::sqrt(1 - sine * sine);
        const double root = cosine * cosine - 2 * sine * sine * d * h;
        if (root < 0.02) continue; // at the outline itself tau is ill-conditioned
        const double tau = 2 * d * h / (cosine + std::sqrt(root));
        ++compared;
        // The fit on a 256-gon is 0.01 % off the curvature, its facets sag by 1 - cos(pi / 256) = 7.5e-5, which moves a
        // fragment by up to 7.5e-5 / cos a along the ray.
        EXPECT_NEAR(vectorAt(frame, "P", pixel).z, cosine - tau, 6e-4 / cosine) << sine;
        // Its normal is N + 2 A x T with x = -tau sin a in the plane of the fragment: turned towards the axis' side.
        const Vec3 normal = vectorAt(frame, "N", pixel);
        const Vec3 fragmentNormal(sine, 0, cosine), tangent(cosine, 0, -sine);
        const Vec3 expected = glm::normalize(fragmentNormal + tangent * (tau * sine));
        EXPECT_LT(glm::length(normal - expected), 3e-3) << sine;
    }
    EXPECT_GT(compared, 40u);
}

TEST(QuadricFrame, OnAPlaneIsTheFlatSurface) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Nothing bends: curvature 0 exactly, so the same samples; only where shadows are cast the frames may differ.
    const auto map = std::make_shared<HeightMap>("profile", 5, 1, std::vector<float>{0, 1, 0.3f, 0.7f, 1});
    Scene scene = sceneOf(squareObject(2, map, 0.3), orthographicCamera({-3, 4, 1}, {0, 0, -1}, 1, 64));
    const Frame flat = draw(scene, "linear_binary:shadow=none"),
                quadric = draw(scene, "linear_binary@quadric");
    for (const std::string& name : flat.channelNames())
        for (size_t i = 0; i < flat.pixelCount(); ++i)
            ASSERT_NEAR(flat.channel(name)[i], quadric.channel(name)[i], 1e-5) << name;
}

} // namespace
} // namespace plumbline
