// Creases, corners and holes on the limit surface, compared with closed forms and with OpenSubdiv's
// refinement.
#include "scenes/surface/base_surface.h"
#include "scenes/surface/topology.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

namespace plumbline {
namespace {

using namespace OpenSubdiv;

BasePoint evaluate(const ControlMesh& mesh, Scheme scheme, int patch, double u, double v) {
    const BaseSurface surface(mesh, scheme);
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(patch);
    return evaluator.point(u, v);
}

/// Uniform cubic B-spline of four control points at t in [0,1] (Farin, Curves and Surfaces, chapter 10).
Vec3 bSpline(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double t) {
    return ((1 - t) * (1 - t) * (1 - t) * a + (3 * t * t * t - 6 * t * t + 4) * b +
            (-3 * t * t * t + 3 * t * t + 3 * t + 1) * c + t * t * t * d) /
           6.0;
}

TEST(Crease, InfinitelySharp_IsCubicBSpline) {
    ControlMesh mesh = bumpyGrid(6);
    for (int i = 0; i < 5; ++i)
        mesh.tags.creases.push_back({12 + i, 13 + i, kInfinitelySharp}); // along j = 2
    const auto& p = mesh.points;
    for (const double t : {0.0, 0.25, 0.3, 0.5, 0.9, 1.0}) {
        const Vec3 expected = bSpline(p[13], p[14], p[15], p[16], t); // from vertex 14 to 15
        // Faces 7 (below the edge) and 12 (above); sums of few products of values near 3: 1e-14.
        EXPECT_LT(glm::length(evaluate(mesh, Scheme::CatmullClark, 7, t, 1).position - expected), 1e-14);
        EXPECT_LT(glm::length(evaluate(mesh, Scheme::CatmullClark, 12, t, 0).position - expected), 1e-14);
    }
    // The normals of the two sides differ.
    EXPECT_GT(glm::length(evaluate(mesh, Scheme::CatmullClark, 7, 0.5, 1).normal -
                          evaluate(mesh, Scheme::CatmullClark, 12, 0.5, 0).normal),
              0.1);
    // Loop has the same curve, because its crease rules are also those of the cubic B-spline (Hoppe et al.
    // 1994). Triangles 14 and 15 are face 7: (8 9 15), (8 15 14); the edge of the second from corner 1 to 2
    // is the crease.
    ControlMesh triangles = triangulated(mesh);
    triangles.tags = mesh.tags;
    const Vec3 middle = bSpline(p[13], p[14], p[15], p[16], 0.5);
    EXPECT_LT(glm::length(evaluate(triangles, Scheme::Loop, 15, 0.5, 0.5).position - middle), 1e-14);
}

TEST(Crease, CubeWithSharpEdges_StaysCube) {
    // Every vertex has three infinitely sharp edges, so it is a corner; edges are straight, faces bilinear.
    ControlMesh mesh = cubeMesh();
    for (int k = 0; k < 8; ++k)
        for (const int bit : {1, 2, 4})
            if (!(k & bit)) mesh.tags.creases.push_back({k, k + bit, 11.0}); // any value from 10 on
    for (const double u : {0.0, 0.3, 1.0})
        for (const double v : {0.0, 0.5, 0.8}) {
            const BasePoint top = evaluate(mesh, Scheme::CatmullClark, 1, u, v);
            EXPECT_LT(glm::length(top.position - Vec3(2 * u - 1, 2 * v - 1, 1)), 1e-14);
            EXPECT_LT(glm::length(top.normal - Vec3(0, 0, 1)), 1e-14);
        }
}

TEST(Crease, SharpVertex_IsCorner) {
    ControlMesh mesh = cubeMesh();
    mesh.tags.corners.push_back({7, kInfinitelySharp});
    EXPECT_LT(glm::length(evaluate(mesh, Scheme::CatmullClark, 1, 1, 1).position - Vec3(1)), 1e-14);
    // Semi-sharp by 1: one step leaves the vertex at (1,1,1) and puts its edge neighbors at (0.75, 0.75, 0)
    // etc. and the face points at (1,0,0) etc.; from there on the smooth limit of Halstead et al. 1993: (9 v
    // + 4 sum(e) + sum(f)) / 24 = (9 + 4 * 1.5 + 1) / 24 = 2/3.
    mesh.tags.corners[0].sharpness = 1;
    EXPECT_LT(glm::length(evaluate(mesh, Scheme::CatmullClark, 1, 1, 1).position - Vec3(2.0 / 3)), 1e-14);
}

TEST(Crease, BoundaryCorners_FollowTheirTag) {
    // A single square from (-1,-1) to (1,1), its boundary the closed cubic B-spline of four points when
    // corners are round: at a vertex (v1 + 4 v + v3) / 6 = (4 - 1 + 1, ...)/6: for v = (1,1), v1 = (-1,1), v3
    // = (1,-1): (4/6, 4/6).
    ControlMesh mesh;
    mesh.name = "square";
    mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    addFace(mesh, {0, 1, 2, 3});
    EXPECT_LT(glm::length(evaluate(mesh, Scheme::CatmullClark, 0, 1, 1).position - Vec3(1, 1, 0)), 1e-14);
    mesh.tags.boundaryCornersRound = true;
    EXPECT_LT(glm::length(evaluate(mesh, Scheme::CatmullClark, 0, 1, 1).position - Vec3(2.0 / 3, 2.0 / 3, 0)),
              1e-14);
}

TEST(Hole, TaggedFace_ShapesNeighborsAndIsNotDrawn) {
    ControlMesh mesh = cubeMesh();
    const Vec3 whole = evaluate(mesh, Scheme::CatmullClark, 2, 0.5, 0.5).position;
    mesh.tags.holes.push_back({1});
    for (const Scheme scheme : {Scheme::CatmullClark, Scheme::None}) {
        const BaseSurface surface(mesh, scheme);
        EXPECT_FALSE(surface.hasLimit(1));
        EXPECT_TRUE(surface.hasLimit(0));
        EXPECT_TRUE(surface.hasLimit(2));
        EXPECT_EQ(surface.patches().size(), 5u);
    }
    EXPECT_EQ(evaluate(mesh, Scheme::CatmullClark, 1, 0.5, 0.5).position, whole); // patch 1 is face 3 now
}

struct RefinedPoint {
    Vec3 value{0};
    void Clear(void* = nullptr) { value = Vec3(0); }
    void AddWithWeight(const RefinedPoint& other, double weight) { value += weight * other.value; }
};

/// Limits of the vertices after `level` uniform refinement steps of OpenSubdiv's Far, which is independent of
/// Bfr's patches.
std::vector<Vec3> refinedLimits(const ControlMesh& mesh, int level) {
    const auto refiner = makeTopology(mesh, Scheme::CatmullClark);
    Far::TopologyRefiner::UniformOptions options(level);
    options.fullTopologyInLastLevel = true;
    refiner->RefineUniform(options);
    const Far::PrimvarRefinerReal<double> primvars(*refiner);
    std::vector<RefinedPoint> points(mesh.points.size());
    for (size_t i = 0; i < points.size(); ++i)
        points[i].value = mesh.points[i];
    for (int l = 1; l <= level; ++l) {
        std::vector<RefinedPoint> next(static_cast<size_t>(refiner->GetLevel(l).GetNumVertices()));
        primvars.Interpolate(l, points, next);
        points = std::move(next);
    }
    std::vector<RefinedPoint> limits(points.size());
    primvars.Limit(points, limits);
    std::vector<Vec3> result;
    for (const RefinedPoint& limit : limits)
        result.push_back(limit.value);
    std::sort(result.begin(), result.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    return result;
}

double distanceToNearest(const std::vector<Vec3>& sortedByZ, const Vec3& point) {
    double nearest = kInfinity;
    for (const Vec3& candidate : sortedByZ)
        nearest = std::min(nearest, glm::length(candidate - point));
    return nearest;
}

TEST(Crease, SemiSharp_EqualsRefinedMesh) {
    // From the level at which the sharpness has decreased to 0, limits of refined vertices are exact and
    // include our samples at dyadic points up to rounding. 7.5 takes 8 levels. 9.5 isn't 0 at level 8, so the
    // vertices differ by less than the edge length of that level (2 / 2^8 = 0.008).
    const std::tuple<double, int, double> cases[] = {{0.5, 5, 2e-15}, {1, 5, 2e-15},   {2.5, 5, 2e-15},
                                                     {4, 5, 2e-15},   {7.5, 8, 2e-15}, {9.5, 8, 0.008}};
    for (const auto& [sharpness, level, bound] : cases) {
        ControlMesh mesh = cubeMesh();
        for (const auto& [from, to] : {std::pair{4, 5}, {5, 7}, {7, 6}, {6, 4}})
            mesh.tags.creases.push_back({from, to, sharpness});
        mesh.tags.creases[1].sharpness = 0.5 * sharpness;
        mesh.tags.corners.push_back({0, 0.75 * sharpness});
        const std::vector<Vec3> refined = refinedLimits(mesh, level);
        const BaseSurface surface(mesh, Scheme::CatmullClark);
        BaseSurface::Evaluator evaluator(surface);
        for (int patch = 0; patch < 6; ++patch) {
            evaluator.setPatch(patch);
            for (const double u : {0.0, 0.5, 0.75, 1.0})
                for (const double v : {0.0, 0.25, 1.0})
                    EXPECT_LT(distanceToNearest(refined, evaluator.point(u, v).position), bound)
                        << sharpness << " patch " << patch << " " << u << " " << v;
        }
    }
}

TEST(Crease, RisingSharpness_MovesSurfaceMonotonically) {
    // The edge loop around a cube's top rises with its sharpness. Smooth, a corner is at z = 0.5 (Halstead et
    // al. 1993).
    double last = 0.5;
    for (const double sharpness : {0.5, 1.0, 2.0, 5.0, 10.0}) {
        ControlMesh mesh = cubeMesh();
        for (const auto& [from, to] : {std::pair{4, 5}, {5, 7}, {7, 6}, {6, 4}})
            mesh.tags.creases.push_back({from, to, sharpness});
        const double z = evaluate(mesh, Scheme::CatmullClark, 1, 1, 1).position.z;
        EXPECT_GT(z, last + 1e-3);
        last = z;
    }
    EXPECT_NEAR(last, 1, 1e-15); // the crease's B-spline is in the plane z = 1
}

} // namespace
} // namespace plumbline
