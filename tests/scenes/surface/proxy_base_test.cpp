// The proxy as a base: identical to the triangles of the real-time renderer, closed, and convergent to the
// limit surface.
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/proxy_mesh.h"
#include "tests/scenes/mesh/mesh_checks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plumbline {
namespace {

SceneObject reliefObject(ControlMesh mesh, Scheme scheme, int proxyRate) {
    SceneObject object;
    object.name = mesh.name;
    object.mesh = std::move(mesh);
    object.scheme = scheme;
    object.proxyRate = proxyRate;
    object.rotateDegrees = {10, 20, 30};
    object.scale = 1.7;
    object.translate = {0.3, -0.2, 5};
    object.relief = Relief{std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f)), 0.1, 0.07,
                           Vec2(3, 2), Vec2(0.25, 0.5)};
    return object;
}

std::vector<SceneObject> objects() {
    ControlMesh tetrahedron;
    tetrahedron.name = "tetrahedron";
    tetrahedron.points = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    tetrahedron.faceSizes.assign(4, 3);
    tetrahedron.faceVertices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    for (int k = 0; k < 12; ++k) {
        tetrahedron.uvs.push_back(Vec2(0.3 * k, 0.7 * ((k * 5) % 12)));
        tetrahedron.faceUvs.push_back(k);
    }
    return {
        reliefObject(makeSphere(1, 2), Scheme::CatmullClark, 3),
        reliefObject(makeTorus(1, 0.4, 6, 5), Scheme::CatmullClark, 1),
        reliefObject(makeBox(Vec3(2), 1), Scheme::None, 2), // hard edges: several normals per place
        reliefObject(tetrahedron, Scheme::Loop, 4),
        reliefObject(tetrahedron, Scheme::CatmullClark, 2),
        reliefObject(tetrahedron, Scheme::None, 3),
        reliefObject(makeQuadric(0.5, -0.2, 1, 2), Scheme::CatmullClark, 2), // faces without a limit surface
        reliefObject(makeCylinder(1, 1, 5, 1), Scheme::CatmullClark, 2)};    // open
}

/// Patch k of the proxy base is triangle k of the proxy; its corners are bit-identical to the proxy's
/// vertices.
TEST(ProxyBase, Corners_AreProxyVertices) {
    for (const SceneObject& object : objects()) {
        SCOPED_TRACE(object.name);
        const ProxyMesh proxy = buildProxyMesh(object);
        const std::unique_ptr<BaseSurface> base = makeBaseSurface(object, Base::Proxy);
        const std::optional<Relief> relief = reliefOn(object, Base::Proxy);
        ASSERT_EQ(base->patches().size(), proxy.triangles.size() / 3);
        BaseSurface::Evaluator evaluator(*base);
        for (size_t k = 0; k < proxy.triangles.size(); ++k) {
            const ProxyVertex& vertex = proxy.vertices[proxy.triangles[k]];
            evaluator.setPatch(static_cast<int>(k / 3));
            const BasePoint corner = evaluator.point(k % 3 == 1, k % 3 == 2);
            ASSERT_EQ(corner.position, vertex.position);
            ASSERT_EQ(textureCoordinates(corner, &*relief), vertex.st);
            ASSERT_LT(glm::length(corner.normal - vertex.normal), 1e-15); // normalized twice
            // The relief is below the triangles: d = 1/2 with a depth of 0.1.
            ASSERT_DOUBLE_EQ(displacement(vertex.st, &*relief), -0.05);
        }
    }
}

TEST(ProxyBase, ClosedLimit_HasClosedProxy) {
    for (const SceneObject& object : objects()) {
        SCOPED_TRACE(object.name);
        const Topology polygons = topologyOf(proxyPolygons(object));
        EXPECT_TRUE(polygons.consistent);
        const bool open = object.name == "quadric" || object.name == "cylinder";
        // The quadric's limit surface has 2 x 2 faces, the cylinder's 5 faces and two boundaries; proxy_rate
        // 2 divides each edge in two.
        EXPECT_EQ(polygons.boundaryEdges, !open ? 0 : object.name == "quadric" ? 4 * 2 * 2 : 2 * 5 * 2);
        if (!open) {
            EXPECT_EQ(polygons.euler(), object.name == "torus" ? 0 : 2);
        }
    }
}

TEST(ProxyBase, Plane_IsPlane) {
    const SceneObject object = reliefObject(makePlane(2, 3, 2, 1), Scheme::CatmullClark, 2);
    const std::unique_ptr<BaseSurface> limit = makeBaseSurface(object),
                                       proxy = makeBaseSurface(object, Base::Proxy);
    const std::optional<Relief> onLimit = reliefOn(object, Base::Limit),
                                onProxy = reliefOn(object, Base::Proxy);
    BaseSurface::Evaluator onLimitAt(*limit), onProxyAt(*proxy);
    onLimitAt.setPatch(0);
    // On the plane st is a linear function of the position, so samples with equal st are equal in all other
    // values.
    const auto atSt = [](BaseSurface::Evaluator& evaluator, const Relief& relief, const Vec2& st) {
        const BaseSample origin = evaluator.sample(0, 0);
        const Vec2 wanted = st - textureCoordinates(origin, &relief);
        const Vec2 uv = glm::inverse(glm::dmat2(relief.tile * origin.uvU, relief.tile * origin.uvV)) * wanted;
        return displace(evaluator.sample(uv.x, uv.y), &relief);
    };
    for (int patch = 0; patch < static_cast<int>(proxy->patches().size()); ++patch) {
        onProxyAt.setPatch(patch);
        for (const Vec2& uv : {Vec2(0.2, 0.3), Vec2(0.6, 0.1)}) {
            const DisplacedSample found = displace(onProxyAt.sample(uv.x, uv.y), &*onProxy);
            if (found.st.x > 0.25 + 3 * 0.5) continue; // the other face of the plane
            const DisplacedSample expected = atSt(onLimitAt, *onLimit, found.st);
            EXPECT_LT(glm::length(found.position - expected.position), 1e-13);
            EXPECT_LT(glm::length(found.normal - expected.normal), 1e-13);
        }
    }
}

/// Largest distance, over all triangles, of their centroids from the limit surface at the mean of their
/// corners' parameters.
double distanceFromLimit(SceneObject object, int proxyRate) {
    object.proxyRate = proxyRate;
    object.relief->offset = 0;
    const std::unique_ptr<BaseSurface> limit = makeBaseSurface(object),
                                       proxy = makeBaseSurface(object, Base::Proxy);
    BaseSurface::Evaluator limitAt(*limit), proxyAt(*proxy);
    double largest = 0;
    int patch = 0;
    for (int face = 0; face < limit->mesh().faceCount(); ++face) {
        const BaseSurface::FaceTessellation cut = limit->tessellateFace(face, proxyRate);
        for (const std::array<int, 4>& facet : cut.facets)
            for (const auto& corners : {std::array<size_t, 3>{0, 1, 3}, std::array<size_t, 3>{1, 2, 3}}) {
                Vec2 uv(0);
                for (const size_t corner : corners) {
                    const auto& sample = cut.samples[static_cast<size_t>(facet[corner])];
                    uv += Vec2(sample.u, sample.v) / 3.0;
                }
                limitAt.setPatch(face); // quads: one patch a face
                proxyAt.setPatch(patch++);
                largest = std::max(largest, glm::length(limitAt.point(uv.x, uv.y).position -
                                                        proxyAt.point(1.0 / 3, 1.0 / 3).position));
            }
    }
    return largest;
}

// A chord deviates from its curve by h^2 / 8 times the curvature, so each doubling of the rate reduces the
// distance to a quarter.
TEST(ProxyBase, RisingRate_ConvergesWithSecondOrder) {
    const SceneObject torus = reliefObject(makeTorus(1, 0.4, 6, 5), Scheme::CatmullClark, 1);
    double coarse = distanceFromLimit(torus, 8);
    for (const int rate : {16, 32, 64}) {
        const double fine = distanceFromLimit(torus, rate);
        EXPECT_NEAR(coarse / fine, 4, 0.1) << rate;
        coarse = fine;
    }
    EXPECT_LT(coarse, 1e-3);
}

// Under the bilinear scheme, Bfr divides a triangle into sub-faces for any rate; here it is a single patch.
TEST(ProxyBase, Polygons_AreTriangulatedWithoutGaps) {
    ControlMesh mesh;
    mesh.name = "triangle";
    mesh.points = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}};
    mesh.faceSizes = {3};
    mesh.faceVertices = {0, 1, 2};
    const BaseSurface surface(mesh, Scheme::None);
    ASSERT_EQ(surface.patches().size(), 1u);
    EXPECT_TRUE(surface.patches()[0].triangular);
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(0);
    for (const int rate : {1, 2, 3, 4, 5, 8}) {
        const BaseSurface::FaceTessellation cut = surface.tessellateFace(0, rate);
        std::vector<Vec3> points;
        for (const auto& sample : cut.samples)
            points.push_back(evaluator.point(sample.u, sample.v).position);
        ASSERT_EQ(cut.boundaryCount, 3 * rate);
        for (int i = 0; i < cut.boundaryCount; ++i) {
            const Vec3 &from = mesh.points[size_t(i / rate)], &to = mesh.points[size_t((i / rate + 1) % 3)];
            EXPECT_LT(glm::length(points[size_t(i)] - glm::mix(from, to, double(i % rate) / rate)), 1e-15);
        }
        double area = 0;
        for (const std::array<int, 4>& facet : cut.facets)
            for (size_t k = 1; k + 1 < (facet[3] < 0 ? 3u : 4u); ++k) {
                const Vec3 &a = points[size_t(facet[0])], &b = points[size_t(facet[k])],
                           &c = points[size_t(facet[k + 1])];
                const double twice = glm::cross(b - a, c - a).z;
                EXPECT_GT(twice, 0) << rate;
                area += twice / 2;
            }
        EXPECT_NEAR(area, 3, 1e-14) << rate;
    }
}

} // namespace
} // namespace plumbline
