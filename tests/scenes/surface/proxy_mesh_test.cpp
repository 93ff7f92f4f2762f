// Compares the proxy with shapes of known curvature and size.
#include "scenes/core/error.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/proxy_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace plumbline {
namespace {

/// Around Y without caps, `around` x `up` quads, points on the cylinder itself.
SceneObject cylinder(int around, int up, double radius, double height) {
    SceneObject object;
    object.name = "cylinder";
    object.scheme = Scheme::None;
    ControlMesh& mesh = object.mesh;
    mesh.name = "cylinder";
    for (int j = 0; j <= up; ++j)
        for (int i = 0; i <= around; ++i) {
            const double angle = 2 * kPi * i / around;
            mesh.uvs.push_back(Vec2(double(i) / around, double(j) / up));
            if (i == around) continue;
            mesh.points.push_back(Vec3(radius * std::sin(angle), height * j / up, radius * std::cos(angle)));
            mesh.normals.push_back(Vec3(std::sin(angle), 0, std::cos(angle)));
        }
    for (int j = 0; j < up; ++j)
        for (int i = 0; i < around; ++i) {
            mesh.faceSizes.push_back(4);
            const int next = (i + 1) % around;
            for (const int v :
                 {j * around + i, j * around + next, (j + 1) * around + next, (j + 1) * around + i})
                mesh.faceVertices.push_back(v);
            for (const int t : {j * (around + 1) + i, j * (around + 1) + i + 1,
                                (j + 1) * (around + 1) + i + 1, (j + 1) * (around + 1) + i})
                mesh.faceUvs.push_back(t);
        }
    mesh.faceNormals = mesh.faceVertices;
    object.relief =
        Relief{std::make_shared<HeightMap>(HeightMap::constant("flat", 0)), 0.1, 0.0, Vec2(1), Vec2(0)};
    return object;
}

TEST(ProxyMesh, Cylinder_HasHalfItsCurvature) {
    // In the frame of a vertex a neighbor at angle h around is x = R sin h (the tangent of the polygon is
    // not exactly e_x, but by symmetry of the ring only x^2 enters), z = -R (1 - cos h). So A = (1 - cos h) /
    // (R sin^2 h) where x is measured in the tangent plane: with h = 2 pi / 64 that is 1/(2R) to within h^2/4
    // = 0.25 %; the polygon's tangent is tilted by h/2, which adds as much again. Neighbors along y lie on
    // the plane: B = 0, up to that tilt.
    for (const double radius : {1e-3, 2.0, 1e3}) {
        const ProxyMesh proxy = buildProxyMesh(cylinder(64, 6, radius, 1.2 * radius));
        ASSERT_EQ(proxy.triangles.size(), 64u * 6 * 2 * 3);
        for (const ProxyVertex& vertex : proxy.vertices) {
            EXPECT_NEAR(vertex.ringQuadric.twoTerms.a * 2 * radius, 1, 0.005); // > 0: convex
            EXPECT_NEAR(vertex.ringQuadric.twoTerms.b * 2 * radius, 0, 0.02);
        }
    }
}

// The ring of a quadric's apex lies on the quadric, so the fit is exact.
TEST(ProxyMesh, QuadricApex_IsExact) {
    SceneObject object;
    object.name = "patch";
    object.mesh = makeQuadric(-2.5, 0.4, 0.5, 4);
    object.proxyRate = 16;
    int apexes = 0;
    for (const ProxyVertex& vertex : buildProxyMesh(object).vertices) {
        if (glm::length(vertex.position) > 1e-12) continue;
        ++apexes;
        EXPECT_NEAR(vertex.ringQuadric.twoTerms.a, 2.5, 1e-9); // A > 0 is convex
        EXPECT_NEAR(vertex.ringQuadric.twoTerms.b, -0.4, 1e-9);
    }
    EXPECT_EQ(apexes, 4); // of the four faces
}

TEST(ProxyMesh, MappingScales_AreTileSize) {
    SceneObject object = cylinder(64, 6, 2.0, 3.0);
    object.relief->tile = Vec2(8, 3);
    const ProxyMesh proxy = buildProxyMesh(object);
    for (const ProxyVertex& vertex : proxy.vertices) {
        // Around: the 64-gon's perimeter over 8 tiles; up: 3 units over 3 tiles.
        EXPECT_NEAR(glm::length(vertex.positionS), 64 * 2 * 2.0 * std::sin(kPi / 64) / 8, 1e-12);
        EXPECT_NEAR(glm::length(vertex.positionT), 1.0, 1e-12);
        EXPECT_NEAR(vertex.st.y * 1.0, vertex.position.y, 1e-12);
    }
}

TEST(ProxyMesh, Offset_PushesOutAndKeepsClosed) {
    SceneObject object = cylinder(16, 2, 1.0, 1.0);
    object.relief->offset = 0.25;
    object.proxyRate = 2;
    object.scheme = Scheme::CatmullClark;
    const ProxyMesh proxy = buildProxyMesh(object);
    EXPECT_EQ(proxy.triangles.size(), 16u * 2 * 4 * 2 * 3);
    for (size_t k = 0; k < proxy.triangles.size(); k += 3) { // counter-clockwise from outside
        const Vec3 a = proxy.vertices[proxy.triangles[k]].position,
                   b = proxy.vertices[proxy.triangles[k + 1]].position,
                   c = proxy.vertices[proxy.triangles[k + 2]].position;
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), Vec3(a.x, 0, a.z)), 0);
    }
    // Limit points of a periodic cubic B-spline through a regular 16-gon lie at r (4 + 2 cos(2 pi/16)) / 6
    // over its vertices; pushed out by 0.25.
    double largest = 0;
    for (const ProxyVertex& vertex : proxy.vertices)
        largest = std::max(largest, std::hypot(vertex.position.x, vertex.position.z));
    EXPECT_NEAR(largest, (4 + 2 * std::cos(2 * kPi / 16)) / 6 + 0.25, 1e-12);
    // There are no cracks: every inner edge, identified by bit-identical positions, is used once in each
    // direction.
    std::map<std::array<double, 6>, int> edges;
    for (size_t k = 0; k < proxy.triangles.size(); ++k) {
        const Vec3 a = proxy.vertices[proxy.triangles[k]].position;
        const Vec3 b = proxy.vertices[proxy.triangles[k % 3 == 2 ? k - 2 : k + 1]].position;
        ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
    }
    int open = 0;
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        open += !edges.count({edge[3], edge[4], edge[5], edge[0], edge[1], edge[2]});
    }
    EXPECT_EQ(open, 2 * 16 * 2); // the two boundaries
}

// Along an axis, the offset only translates the proxy.
TEST(ProxyMesh, OffsetAlongAxis_TranslatesProxy) {
    SceneObject object = cylinder(16, 2, 1.0, 1.0);
    const ProxyMesh there = buildProxyMesh(object);
    object.relief->axisWorld = Vec3(0, 0.6, 0.8);
    object.relief->offset = 0.25;
    const ProxyMesh moved = buildProxyMesh(object);
    ASSERT_EQ(there.vertices.size(), moved.vertices.size());
    for (size_t i = 0; i < there.vertices.size(); ++i) {
        EXPECT_LT(glm::length(moved.vertices[i].position - there.vertices[i].position - Vec3(0, 0.15, 0.2)),
                  1e-15);
        EXPECT_EQ(moved.vertices[i].normal, there.vertices[i].normal);
        EXPECT_NEAR(moved.vertices[i].ringQuadric.twoTerms.a, there.vertices[i].ringQuadric.twoTerms.a,
                    1e-12);
        EXPECT_EQ(moved.vertices[i].limitQuadric.a, there.vertices[i].limitQuadric.a);
    }
}

TEST(ProxyMesh, AnyFaceSizeAndRate_Works) {
    SceneObject object;
    object.name = "prism";
    object.mesh.name = "pentagon prism";
    for (int k = 0; k < 10; ++k)
        object.mesh.points.push_back(
            Vec3(std::cos(2 * kPi * k / 5), k < 5 ? 0 : 1, -std::sin(2 * kPi * k / 5)));
    object.mesh.faceSizes = {5, 5, 4, 4, 4, 4, 4};
    object.mesh.faceVertices = {4, 3, 2, 1, 0, 5, 6, 7, 8, 9};
    for (int k = 0; k < 5; ++k)
        for (const int v : {k, (k + 1) % 5, 5 + (k + 1) % 5, 5 + k})
            object.mesh.faceVertices.push_back(v);
    for (const Scheme scheme : {Scheme::CatmullClark, Scheme::None})
        for (const int rate : {1, 2, 3, 4, 7}) {
            object.scheme = scheme;
            object.proxyRate = rate;
            const ProxyMesh proxy = buildProxyMesh(object);
            double volume = 0; // positive for a closed, outward surface; for polygons, that of the prism
            for (size_t k = 0; k < proxy.triangles.size(); k += 3)
                volume += glm::dot(proxy.vertices[proxy.triangles[k]].position,
                                   glm::cross(proxy.vertices[proxy.triangles[k + 1]].position,
                                              proxy.vertices[proxy.triangles[k + 2]].position)) /
                          6;
            EXPECT_GT(volume, 0);
            if (scheme == Scheme::None) {
                EXPECT_NEAR(volume, 2.5 * std::sin(2 * kPi / 5), 1e-12) << rate;
            }
        }
}

TEST(ProxyMesh, ReliefWithoutUvs_IsRefused) {
    SceneObject object = cylinder(8, 1, 1, 1);
    object.mesh.uvs.clear();
    object.mesh.faceUvs.clear();
    try {
        buildProxyMesh(object);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("cylinder: the mesh 'cylinder' has no texture coordinates"),
                  std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace plumbline
