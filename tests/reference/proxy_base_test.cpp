// Compares renderings of the proxy base with independently computed intersections of rays and triangles.
#include "reference/reference.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/proxy_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

/// A sphere of radius 1 as a coarse proxy, seen from +z, with a relief of one depth everywhere.
Scene sphereScene(float reliefDepth, double offset) {
    Scene scene;
    scene.name = "sphere";
    scene.camera.positionWorld = {0.3, 0.2, 4};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.width = scene.camera.height = 64;
    SceneObject sphere;
    sphere.name = "sphere";
    sphere.mesh = makeSphere(1, 2);
    sphere.relief = Relief{std::make_shared<HeightMap>(HeightMap::constant("flat", reliefDepth)), 0.2, offset,
                           Vec2(1), Vec2(0)};
    scene.objects.push_back(sphere);
    return scene;
}

Frame renderOn(const Scene& scene, Base base, int rate) {
    ReferenceOptions options;
    options.base = base;
    options.rate = rate;
    return ReferenceScene(scene, options).render();
}

/// Intersection of a ray with the proxy's triangles, with barycentric coordinates by Cramer's rule.
struct ProxyHit {
    double distance = kInfinity;
    Vec3 normal{0}, facetNormal{0}; // interpolated; geometric; both unit
};
ProxyHit nearestHit(const ProxyMesh& proxy, const Ray& ray) {
    ProxyHit nearest;
    for (size_t k = 0; k < proxy.triangles.size(); k += 3) {
        const ProxyVertex &a = proxy.vertices[proxy.triangles[k]],
                          &b = proxy.vertices[proxy.triangles[k + 1]],
                          &c = proxy.vertices[proxy.triangles[k + 2]];
        // origin + t direction = a + beta (b - a) + gamma (c - a)
        const Mat3 columns(b.position - a.position, c.position - a.position, -ray.direction);
        if (glm::determinant(columns) == 0) continue;
        const Vec3 solution = glm::inverse(columns) * (ray.origin - a.position);
        const double beta = solution.x, gamma = solution.y,
                     inside = std::min({beta, gamma, 1 - beta - gamma});
        if (inside < 0 || solution.z <= 0 || solution.z >= nearest.distance) continue;
        nearest = {solution.z,
                   glm::normalize((1 - beta - gamma) * a.normal + beta * b.normal + gamma * c.normal),
                   glm::normalize(glm::cross(columns[0], columns[1]))};
    }
    return nearest;
}

/// Expects the coverage, position and normal of the proxy's triangles at every pixel. Float vertices have
/// errors of 6e-8; hits on facets seen edge-on many times that.
void expectPolygons(const Scene& scene, int rate, Vec3 ProxyHit::*normal) {
    const ProxyMesh proxy = buildProxyMesh(scene.objects[0]);
    const CameraRays rays(scene.camera);
    const Frame frame = renderOn(scene, Base::Proxy, rate);
    EXPECT_EQ(frame.metadata.at("base"), "proxy");
    int covered = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto at = [&](const char* name) { return double(frame.channel(name)[size_t(64 * y + x)]); };
            const Ray ray = rays.ray(x + 0.5, y + 0.5);
            const ProxyHit hit = nearestHit(proxy, ray);
            ASSERT_EQ(at("A"), hit.distance < kInfinity) << x << " " << y;
            if (hit.distance == kInfinity) continue;
            ++covered;
            EXPECT_LT(glm::length(Vec3(at("P.X"), at("P.Y"), at("P.Z")) - ray.at(hit.distance)), 1e-5)
                << x << " " << y;
            EXPECT_LT(glm::length(Vec3(at("N.X"), at("N.Y"), at("N.Z")) - hit.*normal), 2e-6)
                << x << " " << y;
        }
    EXPECT_GT(covered, 500);
}

// Without a relief, the proxy is rendered with its interpolated normals. With a relief of d = 0, for any
// offset, the triangles are only moved by the offset, and N, the normal of P, is the geometric normal. The
// rate has no effect, because subdividing a triangle doesn't change it.
TEST(ProxyBase, ZeroDepth_RendersPolygons) {
    for (const int rate : {1, 8}) {
        SCOPED_TRACE(rate);
        expectPolygons(sphereScene(0, 0.1), rate, &ProxyHit::facetNormal);
        Scene bare = sphereScene(0, 0);
        bare.objects[0].relief.reset();
        expectPolygons(bare, rate, &ProxyHit::normal);
    }
}

// d = 1/2 with a depth of 0.2: the surface is 0.1 below the triangles along the interpolated normals. So for
// a hit at P with the normal n, P + 0.1 n lies on a triangle of the proxy. P is on a micro-triangle, below
// the surface by up to h^2 / 8 times its curvature. A side of the triangles is up to 1.2 long, h = 1.2 / 64,
// and normals rotate by up to 1.2 per unit: 0.1 * 1.2^2 * h^2 / 8 = 6e-6.
TEST(ProxyBase, ConstantDepth_LiesBelowTriangles) {
    const Scene scene = sphereScene(0.5f, 0.1);
    const ProxyMesh proxy = buildProxyMesh(scene.objects[0]);
    const Frame frame = renderOn(scene, Base::Proxy, 64);
    int covered = 0;
    for (size_t i = 0; i < frame.pixelCount(); ++i) {
        if (frame.channel("A")[i] == 0) continue;
        const Vec3 position(frame.channel("P.X")[i], frame.channel("P.Y")[i], frame.channel("P.Z")[i]);
        // The triangle point X with X - 0.1 n(X) = P: found by the fixed-point iteration X <- P + 0.1 n(X),
        // with n from the triangle that the ray from the sphere's center through X intersects. n varies
        // slowly, so each step reduces the error to about a tenth.
        Vec3 onTriangle = position * 1.1;
        ProxyHit hit;
        for (int step = 0; step < 12; ++step) {
            hit = nearestHit(proxy, {Vec3(0), glm::normalize(onTriangle)});
            onTriangle = position + 0.1 * hit.normal;
        }
        EXPECT_LT(std::abs(glm::length(onTriangle) - hit.distance), 7e-6) << i;
        ++covered;
    }
    EXPECT_GT(covered, 500);
}

// With a fine proxy, both bases agree: at proxy_rate 64, chords of the sphere's arcs (an eighth of a circle
// per control edge, at most 1.2 long) deviate by (1.2/64)^2 / 8 = 4.4e-5 along each of two directions.
TEST(ProxyBase, FineProxy_RendersLimit) {
    Scene scene = sphereScene(0.5f, 0.1);
    scene.objects[0].proxyRate = 64;
    const Frame limit = renderOn(scene, Base::Limit, 64), proxy = renderOn(scene, Base::Proxy, 1);
    EXPECT_EQ(limit.metadata.at("base"), "limit");
    int covered = 0;
    for (size_t i = 0; i < limit.pixelCount(); ++i) {
        ASSERT_EQ(limit.channel("A")[i], proxy.channel("A")[i]) << i;
        if (limit.channel("A")[i] == 0) continue;
        ++covered;
        const auto at = [&](const char* x, const char* y, const char* z) {
            return Vec3(limit.channel(x)[i], limit.channel(y)[i], limit.channel(z)[i]);
        };
        const Vec3 toCamera = glm::normalize(scene.camera.positionWorld - at("P.X", "P.Y", "P.Z"));
        // The error is larger for oblique views, and near the silhouette the change of the cosine doubles it.
        const double cosine = std::abs(glm::dot(at("N.X", "N.Y", "N.Z"), toCamera));
        EXPECT_NEAR(limit.channel("Z")[i], proxy.channel("Z")[i], 2 * 4.4e-5 / std::max(cosine, 0.01) + 1e-6)
            << i;
    }
    EXPECT_GT(covered, 500);
}

} // namespace
} // namespace plumbline
