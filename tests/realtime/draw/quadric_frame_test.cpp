// Compares silhouettes over curved bases with the closed form of the quadric model.
#include "tests/realtime/gl_fixture.h"

#include <cmath>

namespace plumbline {
namespace {

constexpr int kPixels = 512;

/// A cylinder around Y with radius 1 and 256 sides, with a relief of constant d and depth `depth`.
Scene cylinderScene(float d, double depth) {
    SceneObject object;
    object.name = "cylinder";
    object.mesh = makeCylinder(1, 2, 256, 4);
    object.scheme = Scheme::None;
    object.relief = Relief{std::make_shared<HeightMap>(HeightMap::constant("constant", d)), depth, 0,
                           Vec2(6, 2), Vec2(0)};
    return sceneOf(object, orthographicCamera({0, 0, 5}, {0, 1, 0}, 2.4, kPixels));
}

/// Half of the covered width in the middle row, world units.
double halfWidth(const Frame& frame) {
    int covered = 0;
    for (int x = 0; x < kPixels; ++x)
        covered += frame.channel("A")[pixelAt(frame, x, kPixels / 2)] > 0;
    return 0.5 * covered * 2.4 / kPixels;
}

TEST(QuadricOutline, Cylinder_HasOutlineOfOsculatingParabola) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Fragment at angle a from the viewing direction: v_d = cos a / h, f = sin^2 a / (2 R h) for a relief h
    // deep. The ray gets no deeper than v_d^2 / (4 f) = R cos^2 a / (2 h sin^2 a); it reaches the depth D if
    // that is >= D, so the silhouette is at sin a = 1 / sqrt(1 + 2 D h / R) (the true one, of the radius R -
    // D h, is at 1 - D h / R). Errors: one pixel (0.0047), and the linear search (1000 steps, because the ray
    // is below D only for a short interval, 1e-3 of its length).
    for (const auto& [d, depth] : {std::pair(0.5f, 0.2), std::pair(1.0f, 0.1), std::pair(0.25f, 0.6)}) {
        const Frame frame = draw(cylinderScene(d, depth), "linear_binary@quadric:linear_steps=1000");
        const double expected = 1 / std::sqrt(1 + 2 * d * depth);
        EXPECT_NEAR(halfWidth(frame), expected, 0.005) << d << " " << depth;
        // On the flat surface the silhouette is the polygon's.
        EXPECT_NEAR(halfWidth(draw(cylinderScene(d, depth), "linear_binary")), 1, 0.003);
    }
}

TEST(QuadricFrame, Positions_LieOnParabola) {
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
        if (root < 0.02) continue; // at the silhouette tau is ill-conditioned
        const double tau = 2 * d * h / (cosine + std::sqrt(root));
        ++compared;
        // The curvature fitted to a 256-gon has an error of 0.01 %. Its facets are up to 1 - cos(pi / 256) =
        // 7.5e-5 below the circle, which moves a fragment by up to 7.5e-5 / cos a along the ray.
        EXPECT_NEAR(vectorAt(frame, "P", pixel).z, cosine - tau, 6e-4 / cosine) << sine;
        // Its normal is N + 2 A x T with x = -tau sin a in the plane of the fragment: rotated toward the
        // axis.
        const Vec3 normal = vectorAt(frame, "N", pixel);
        const Vec3 fragmentNormal(sine, 0, cosine), tangent(cosine, 0, -sine);
        const Vec3 expected = glm::normalize(fragmentNormal + tangent * (tau * sine));
        EXPECT_LT(glm::length(normal - expected), 3e-3) << sine;
    }
    EXPECT_GT(compared, 40u);
}

TEST(QuadricOutline, DistanceVariants_HaveTheirOutlines) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The same cylinder. The ray is tangent to the relief where it is orthogonal to the base's normal, so
    // that D_U and D_n agree there: D_U reaches D h if cos^2 a >= 4 k D h sin a with k = 1 / (2 R), that is
    // sin a <= sqrt(1 + x^2) - x with x = D h / R, closer to the true 1 - x than D_z's 1 / sqrt(1 + 2 x).
    // Errors as above; of 200 steps one is within 1/100 of the interval of the deepest point, where d is at
    // most 1e-4 too small.
    for (const auto& [d, depth] : {std::pair(1.0f, 0.1), std::pair(0.5f, 0.5)})
        for (const char* surface : {"quadric_perpendicular", "quadric_nearest"}) {
            const Frame frame = draw(cylinderScene(d, depth), std::string("linear_binary@") + surface +
                                                                  ":linear_steps=200,binary_steps=16");
            const double x = d * depth;
            EXPECT_NEAR(halfWidth(frame), std::sqrt(1 + x * x) - x, 0.005)
                << surface << " " << d << " " << depth;
        }
}

/// A square with ridges seen at 45 degrees and slightly from the side.
Scene planeScene(double depth) {
    const auto map = std::make_shared<HeightMap>("profile", 5, 1, std::vector<float>{0, 1, 0.3f, 0.7f, 1});
    return sceneOf(squareObject(2, map, depth), orthographicCamera({-3, 4, 1}, {0, 0, -1}, 1, 64));
}

TEST(QuadricFrame, Plane_EqualsFlatSurface) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The curvature is exactly 0, so the samples agree up to a few rounding errors; the frames may only
    // differ in cast shadows.
    const Frame flat = draw(planeScene(0.3), "linear_binary:shadow=none");
    for (const char* surface :
         {"quadric", "quadric_full", "quadric_nearest", "quadric_nearest:texture_from=ray",
          "quadric:coefficients=limit", "quadric_full:coefficients=limit"}) {
        const Frame quadric = draw(planeScene(0.3), std::string("linear_binary@") + surface);
        for (const std::string& name : flat.channelNames())
            for (size_t i = 0; i < flat.pixelCount(); ++i)
                ASSERT_NEAR(flat.channel(name)[i], quadric.channel(name)[i], 1e-5) << surface << " " << name;
    }
}

TEST(QuadricFrame, PerpendicularDistanceOnPlane_IsShallowerBySine) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // D_U of a plane is the depth divided by the sine between ray and normal, which is equal for all rays of
    // this camera: positions are those of a flat relief with depth sz sine.
    const double sine = std::sqrt(10.0 / 26);
    const Frame flat = draw(planeScene(0.3 * sine), "linear_binary:shadow=none"),
                perpendicular = draw(planeScene(0.3), "linear_binary@quadric_perpendicular"),
                unscaled = draw(planeScene(0.3), "linear_binary:shadow=none");
    double least = 0;
    for (const char* name : {"Z", "P.X", "P.Y", "P.Z", "st.S", "st.T", "A"})
        for (size_t i = 0; i < flat.pixelCount(); ++i) {
            ASSERT_NEAR(flat.channel(name)[i], perpendicular.channel(name)[i], 1e-5) << name;
            least =
                std::max(least, std::abs(double(unscaled.channel(name)[i]) - perpendicular.channel(name)[i]));
        }
    EXPECT_GT(least, 0.05); // it differs from the flat surface
}

TEST(QuadricFrame, ConvexOutline_StaysInsidePolygons) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // No surface creates fragments outside the polygon, and all of them discard some. The silhouette of a
    // sphere of radius 1 with a relief of depth D h = 0.1 is at 0.9, those of the paraboloids at 0.913 (D_z)
    // and 0.905; the fragments' fitted curvature is accurate to a few per cent.
    SceneObject sphere;
    sphere.name = "sphere";
    sphere.mesh = makeSphere(1, 16);
    sphere.relief = Relief{std::make_shared<HeightMap>(HeightMap::constant("constant", 0.5)), 0.2, 0,
                           Vec2(4, 2), Vec2(0)};
    SceneObject torus = sphere;
    torus.name = "torus";
    torus.mesh = makeTorus(1, 0.4, 48, 24);
    for (const SceneObject& object : {sphere, torus}) {
        const Scene scene = sceneOf(object, orthographicCamera({0, 5, 0.01}, {0, 0, -1}, 3, 256));
        const Frame flat = draw(scene, "linear_binary");
        for (const char* surface : {"quadric", "quadric_full", "quadric_perpendicular", "quadric_nearest",
                                    "quadric_full:coefficients=limit"}) {
            const Frame frame = draw(scene, std::string("linear_binary@") + surface);
            for (int y = 1; y < 255; ++y)
                for (int x = 1; x < 255; ++x) {
                    if (frame.channel("A")[pixelAt(frame, x, y)] == 0) continue;
                    bool near = false;
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx)
                            near = near || flat.channel("A")[pixelAt(flat, x + dx, y + dy)] > 0;
                    ASSERT_TRUE(near) << object.name << " " << surface << " " << x << " " << y;
                }
            int covered = 0, whole = 0;
            for (int x = 0; x < 256; ++x) {
                covered += frame.channel("A")[pixelAt(frame, x, 128)] > 0;
                whole += flat.channel("A")[pixelAt(flat, x, 128)] > 0;
            }
            if (object.name == "sphere") {
                EXPECT_NEAR(covered / double(whole), 0.909, 0.02) << surface;
            } else {
                EXPECT_LT(covered, whole - 5) << surface;
            }
        }
    }
}

TEST(QuadricFrame, Coefficients_AreThoseRequested) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The uvs of the saddle z = 0.3 (x^2 - y^2) are rotated by 45 degrees, so the patch has no curvature
    // along s and t but a cross term C = 0.6 or -0.6 at its center. For a proxy with two segments per face,
    // the chords give an error of 2 %.
    SceneObject object;
    object.name = "saddle";
    object.mesh = makeQuadric(0.3, -0.3, 1, 8);
    for (Vec2& uv : object.mesh.uvs)
        uv = Vec2(uv.x + uv.y, uv.y - uv.x);
    object.proxyRate = 2;
    object.relief =
        Relief{std::make_shared<HeightMap>(HeightMap::constant("constant", 0)), 0.1, 0, Vec2(1), Vec2(0)};
    const Scene scene = sceneOf(object, orthographicCamera({0, 0, 5}, {0, 1, 0}, 0.2, 32));
    RealtimeRenderer renderer(scene, {GlBackend::Auto, -1, 0},
                              testContext()); // shared; each draw selects its coefficients
    const auto middle = [&](const char* technique, const char* channel) {
        const Frame frame = renderer.render(resolveTechnique(technique), nullptr).frame;
        return double(frame.channel(channel)[pixelAt(frame, 16, 16)]);
    };
    for (const char* full :
         {"linear_binary@quadric_full", "linear_binary@quadric_nearest:coefficients=limit"})
        EXPECT_NEAR(std::abs(middle(full, "curvature.cross")), 0.6, 0.02) << full;
    const double ring = middle("linear_binary@quadric_full", "curvature.cross"),
                 limit = middle("linear_binary@quadric_full:coefficients=limit", "curvature.cross");
    EXPECT_NE(ring, limit);
    EXPECT_NEAR(ring, limit, 0.01);
    for (const char* twoTerms : {"linear_binary@quadric", "linear_binary@quadric:coefficients=limit",
                                 "linear_binary@quadric_perpendicular"}) {
        EXPECT_EQ(middle(twoTerms, "curvature.cross"), 0) << twoTerms;
        EXPECT_NEAR(middle(twoTerms, "curvature.a"), 0, 0.01) << twoTerms;
    }
    // A cylinder, for which A isn't 0 and both are equal.
    const Scene cylinder = cylinderScene(0, 0.1);
    for (const char* technique : {"linear_binary@quadric", "linear_binary@quadric:coefficients=limit"}) {
        const Frame frame = draw(cylinder, technique);
        EXPECT_NEAR(frame.channel("curvature.a")[pixelAt(frame, kPixels / 2, kPixels / 2)], 0.5, 0.002)
            << technique;
        EXPECT_NEAR(frame.channel("curvature.b")[pixelAt(frame, kPixels / 2, kPixels / 2)], 0, 0.002)
            << technique;
    }
}

TEST(QuadricFrame, SampledDepth_WorksOnEveryBase) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // For a constant map, the sampled depth is that of the hit, so sampled_depth is a Newton step with the
    // ray's descent. Without secant steps, the remaining error is quadratic in the step length, a small
    // fraction of it, on every base.
    for (const char* surface : {"quadric", "quadric_full", "quadric_perpendicular", "quadric_nearest"}) {
        const std::string search = std::string("linear_secant@") + surface;
        const Frame hit = draw(cylinderScene(0.5f, 0.2),
                               search + ":linear_steps=20,max_iterations=30,tolerance=0.000001"),
                    step = draw(cylinderScene(0.5f, 0.2), search + ":linear_steps=20,max_iterations=0"),
                    sampled = draw(cylinderScene(0.5f, 0.2),
                                   search + ":linear_steps=20,max_iterations=0,answer=sampled_depth");
        double ofStep = 0, ofSampled = 0;
        for (size_t i = 0; i < hit.pixelCount(); ++i) {
            // Away from the silhouette, where rays hardly descend.
            if (hit.channel("A")[i] == 0 || hit.channel("P.Z")[i] < 0.5f) continue;
            ofStep += std::abs(step.channel("Z")[i] - hit.channel("Z")[i]);
            ofSampled += std::abs(sampled.channel("Z")[i] - hit.channel("Z")[i]);
        }
        EXPECT_GT(ofStep, 1) << surface;
        EXPECT_LT(ofSampled, 0.1 * ofStep) << surface;
    }
}

} // namespace
} // namespace plumbline
