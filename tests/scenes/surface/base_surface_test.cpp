// Compares the base surface with closed forms.
#include "scenes/core/error.h"
#include "scenes/surface/base_surface.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/shared_samples.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plumbline {
namespace {

/// Control points on an n x n grid in x and z, with y a function of both; faces point toward +Y.
template <typename Height>
ControlMesh gridMesh(int side, Height height) {
    ControlMesh mesh;
    mesh.name = "grid";
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            mesh.points.push_back(Vec3(i, height(i, j), -j));
            mesh.uvs.push_back(Vec2(i, j));
        }
    for (int j = 0; j + 1 < side; ++j)
        for (int i = 0; i + 1 < side; ++i) {
            mesh.faceSizes.push_back(4);
            for (const int v : {j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i})
                mesh.faceVertices.push_back(v);
        }
    mesh.faceUvs = mesh.faceVertices;
    return mesh;
}

/// Uniform cubic B-spline basis over one segment (e.g. Farin, Curves and Surfaces, ch. 10).
std::array<double, 4> basis(double t) {
    return {(1 - t) * (1 - t) * (1 - t) / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
            (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
}

double bumpyHeight(int i, int j) {
    return std::sin(1.7 * i + 0.3 * j * j) + 0.25 * i * j;
}

TEST(BaseSurface, RegularPatch_IsBicubicBSpline) {
    ControlMesh mesh = gridMesh(4, bumpyHeight);
    mesh.boundaryFacesSupportOnly = true;
    const BaseSurface surface(mesh, Scheme::CatmullClark);
    ASSERT_EQ(surface.patches().size(), 1u); // of nine faces, only the middle one has a limit surface
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(0);
    for (const double u : {0.0, 0.25, 0.3, 0.77, 1.0})
        for (const double v : {0.0, 0.125, 0.6, 1.0}) {
            Vec3 expected(0);
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    expected += basis(u)[size_t(i)] * basis(v)[size_t(j)] * mesh.points[size_t(4 * j + i)];
            // 16 products of values near 1: rounding stays below 1e-14.
            EXPECT_LT(glm::length(evaluator.point(u, v).position - expected), 1e-14);
            EXPECT_LT(glm::length(evaluator.point(u, v).uv - Vec2(1 + u, 1 + v)), 1e-14);
        }
}

TEST(BaseSurface, CubeCorner_HasHalstead1993Limit) {
    // Halstead et al. 1993, appendix: limit of a vertex of valence n = (n^2 v + 4 sum(e) + sum(f)) / (n (n +
    // 5)), e its edge neighbors, f the opposite corners of its quads. Cube of +-1, corner (1,1,1): sum(e) =
    // (1,1,1), sum(f) = (-1,-1,-1), so (9 + 4 - 1) / 24 = 1/2. The normal is the diagonal by symmetry.
    const BaseSurface surface(cubeMesh(), Scheme::CatmullClark);
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(1); // 4 5 7 6: its corner 2, at (1,1), is vertex 7
    const BasePoint corner = evaluator.point(1, 1);
    EXPECT_LT(glm::length(corner.position - Vec3(0.5)), 1e-14);
    EXPECT_LT(glm::length(corner.normal - Vec3(1) / std::sqrt(3.0)),
              1e-6); // the level-10 patch at the vertex
}

TEST(BaseSurface, NormalDerivatives_MatchDifferences) {
    const BaseSurface surface(gridMesh(5, bumpyHeight), Scheme::CatmullClark);
    BaseSurface::Evaluator evaluator(surface);
    // Central difference: truncation h^2 n'''/6 ~ 1e-9, rounding 1e-16/h ~ 1e-11.
    const double h = 1e-5, bound = 1e-7;
    for (int patch = 0; patch < static_cast<int>(surface.patches().size()); ++patch) {
        evaluator.setPatch(patch);
        const double u = 0.4, v = 0.55;
        const BaseSample s = evaluator.sample(u, v);
        EXPECT_NEAR(glm::length(s.normal), 1, 1e-15);
        EXPECT_LT(
            glm::length(s.normalU -
                        (evaluator.point(u + h, v).normal - evaluator.point(u - h, v).normal) / (2 * h)),
            bound);
        EXPECT_LT(
            glm::length(s.normalV -
                        (evaluator.point(u, v + h).normal - evaluator.point(u, v - h).normal) / (2 * h)),
            bound);
        EXPECT_LT(
            glm::length(s.positionU -
                        (evaluator.point(u + h, v).position - evaluator.point(u - h, v).position) / (2 * h)),
            bound);
    }
}

/// Patches of n-gons and triangles: compares derivatives with finite differences in patch coordinates.
TEST(BaseSurface, SubFaces_AreParameterizedPerPatch) {
    ControlMesh mesh;
    mesh.name = "pentagon pyramid";
    for (int k = 0; k < 5; ++k)
        mesh.points.push_back(Vec3(std::cos(2 * kPi * k / 5), std::sin(2 * kPi * k / 5), 0));
    mesh.points.push_back(Vec3(0, 0, 2));
    mesh.faceSizes = {5, 3, 3, 3, 3, 3};
    mesh.faceVertices = {4, 3, 2, 1, 0};
    for (int k = 0; k < 5; ++k)
        for (const int v : {k, (k + 1) % 5, 5})
            mesh.faceVertices.push_back(v);
    for (const Scheme scheme : {Scheme::CatmullClark, Scheme::None}) {
        const BaseSurface surface(mesh, scheme);
        ASSERT_EQ(surface.patches().size(),
                  scheme == Scheme::None ? 5u + 5 : 5u + 5 * 3); // triangles: one patch, or three sub-faces
        BaseSurface::Evaluator evaluator(surface);
        Vec3 center(0);
        for (int patch = 0; patch < 5; ++patch) {
            evaluator.setPatch(patch);
            const double h = 1e-6;
            const BaseSample s = evaluator.sample(0.5, 0.25);
            const Vec3 difference =
                (evaluator.point(0.5 + h, 0.25).position - evaluator.point(0.5 - h, 0.25).position) / (2 * h);
            EXPECT_LT(glm::length(s.positionU - difference), 1e-8);
            EXPECT_LT(s.normal.z, 0); // the base faces down
            const Vec3 at = evaluator.point(1, 1).position;
            if (patch > 0) { // all five meet at the face's center
                EXPECT_LT(glm::length(at - center), 1e-14);
            }
            center = at;
        }
    }
}

TEST(BaseSurface, LoopOnFlatCage_IsFlat) {
    ControlMesh mesh;
    mesh.name = "hexagon";
    mesh.points.push_back(Vec3(0));
    for (int k = 0; k < 6; ++k)
        mesh.points.push_back(Vec3(std::cos(kPi * k / 3), std::sin(kPi * k / 3), 0));
    for (int k = 0; k < 6; ++k) {
        mesh.faceSizes.push_back(3);
        for (const int v : {0, 1 + k, 1 + (k + 1) % 6})
            mesh.faceVertices.push_back(v);
    }
    const BaseSurface surface(mesh, Scheme::Loop);
    ASSERT_EQ(surface.patches().size(), 6u);
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(0);
    EXPECT_TRUE(surface.patches()[0].triangular);
    EXPECT_LT(glm::length(evaluator.point(0, 0).position), 1e-14); // by symmetry the center stays
    EXPECT_LT(glm::length(evaluator.point(0.25, 0.25).normal - Vec3(0, 0, 1)), 1e-14);
}

TEST(BaseSurface, Polygons_TakeFileNormalsElseAngleWeighted) {
    // A roof: two unit squares over z in [-1,0] and [0,1], folded along x at 90 degrees. At the ridge both
    // faces have an angle of 90 degrees, so the normal is their mean, straight up; at the eaves it is the
    // face normal.
    ControlMesh mesh;
    mesh.name = "roof";
    mesh.points = {{0, 0, 1}, {1, 0, 1}, {1, 1, 0}, {0, 1, 0}, {1, 0, -1}, {0, 0, -1}};
    mesh.faceSizes = {4, 4};
    mesh.faceVertices = {0, 1, 2, 3, 3, 2, 4, 5};
    const BaseSurface smooth(mesh, Scheme::None);
    BaseSurface::Evaluator evaluator(smooth);
    evaluator.setPatch(0);
    EXPECT_LT(glm::length(evaluator.point(0, 1).normal - Vec3(0, 1, 0)), 1e-15);
    EXPECT_LT(glm::length(evaluator.point(0, 0).normal - Vec3(0, 1, 1) / std::sqrt(2.0)), 1e-15);
    // Half way up: the mean of both, renormalized.
    EXPECT_LT(glm::length(evaluator.point(0.3, 0.5).normal -
                          glm::normalize(Vec3(0, 1, 0) + Vec3(0, 1, 1) / std::sqrt(2.0))),
              1e-15);
    mesh.normals = {{1, 0, 0}};
    mesh.faceNormals.assign(8, 0);
    const BaseSurface given(mesh, Scheme::None);
    BaseSurface::Evaluator evaluatorGiven(given);
    evaluatorGiven.setPatch(1);
    EXPECT_EQ(evaluatorGiven.point(0.5, 0.5).normal, Vec3(1, 0, 0));
}

TEST(BaseSurface, SharedSamples_AgreeFromBothSides) {
    const BaseSurface surface(gridMesh(5, bumpyHeight), Scheme::CatmullClark);
    const int rate = 4;
    const SharedSamples shared(surface, rate);
    BaseSurface::Evaluator evaluator(surface);
    std::vector<Vec3> seen(shared.count(), Vec3(kInfinity));
    int met = 0;
    for (int face = 0; face < surface.mesh().faceCount(); ++face) {
        const BaseSurface::FaceTessellation cut = surface.tessellateFace(face, rate);
        ASSERT_EQ(cut.boundaryCount, 4 * rate);
        for (int i = 0; i < cut.boundaryCount; ++i) {
            const auto& sample = cut.samples[size_t(i)];
            evaluator.setPatch(sample.patch);
            const Vec3 position = evaluator.point(sample.u, sample.v).position;
            Vec3& first = seen[shared.onEdge(face, i / rate, i % rate)];
            if (first.x == kInfinity) {
                first = position;
                continue;
            }
            ++met;
            EXPECT_LT(glm::length(first - position), 1e-14);
        }
    }
    EXPECT_EQ(met, 4 * 4 * 4 * rate - (5 * 5 + 40 * (rate - 1))); // 16 faces; 25 vertices, 40 edges
}

TEST(DisplacedSurface, RampOnPlane_TiltsIt) {
    // d = s over one texel pair: map {0, 1} of width 2, centers at 1/4 and 3/4, so between them d = 2 (s -
    // 1/4) and d_s = 2. On the plane y = 0 with uv = (x, -z), depth 0.5: y = -0.5 d, slope -1 along x, normal
    // (1, 1, 0)/sqrt 2.
    ControlMesh mesh = gridMesh(2, [](int, int) { return 0; });
    const BaseSurface surface(mesh, Scheme::None);
    Relief relief;
    relief.map =
        std::make_shared<HeightMap>("ramp", 2, 1, std::vector<float>{0, 1}, Wrap::Clamp, Wrap::Clamp);
    relief.depth = 0.5;
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(0);
    const DisplacedSample s = displace(evaluator.sample(0.5, 0.3), &relief);
    EXPECT_LT(glm::length(s.position - Vec3(0.5, -0.25, -0.3)), 1e-15);
    EXPECT_LT(glm::length(s.normal - Vec3(1, 1, 0) / std::sqrt(2.0)), 1e-15);
    EXPECT_DOUBLE_EQ(s.reliefDepth, 0.5);
    // Tiling by 2 doubles the slope: -2 along x; the offset raises the surface.
    relief.tile = Vec2(2, 1);
    relief.offset = 0.1;
    const DisplacedSample tiled = displace(evaluator.sample(0.25, 0.3), &relief);
    EXPECT_LT(glm::length(tiled.position - Vec3(0.25, 0.1 - 0.25, -0.3)), 1e-15);
    EXPECT_LT(glm::length(tiled.normal - glm::normalize(Vec3(2, 1, 0))), 1e-15);
}

TEST(DisplacedSurface, CurvedBase_NormalMatchesDifferences) {
    const BaseSurface surface(gridMesh(5, bumpyHeight), Scheme::CatmullClark);
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    Relief relief{std::make_shared<HeightMap>("noise", 8, 8, depths), 0.3, 0.1, Vec2(0.71, 1.3),
                  Vec2(0.2, 0.1)};
    BaseSurface::Evaluator evaluator(surface);
    for (int patch = 0; patch < 16; ++patch) {
        evaluator.setPatch(patch);
        const auto position = [&](double u, double v) {
            return displace(evaluator.sample(u, v), &relief).position;
        };
        const double u = 0.41, v = 0.53, h = 1e-6; // no texel crease within h of these for any patch
        const Vec3 byDifference = glm::normalize(
            glm::cross(position(u + h, v) - position(u - h, v), position(u, v + h) - position(u, v - h)));
        EXPECT_LT(glm::length(displace(evaluator.sample(u, v), &relief).normal - byDifference), 1e-7);
    }
}

} // namespace
} // namespace plumbline
