#include "realtime/draw/back_sides.h"

#include "scenes/mesh/mesh_edges.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

struct Corners {
    Vec3 a, b, c;
};

template <class Visit>
void forEachTriangle(const ProxyMesh& proxy, const Visit& visit) {
    const auto position = [&](size_t i) { return proxy.vertices[proxy.triangles[i]].position; };
    for (size_t i = 0; i + 2 < proxy.triangles.size(); i += 3)
        visit(Corners{position(i), position(i + 1), position(i + 2)});
}

bool showsAnyBack(const ProxyMesh& proxy, const Viewer& viewer) {
    bool shows = false;
    forEachTriangle(proxy, [&](const Corners& t) {
        const Vec3 toViewer = viewer.distant ? viewer.place : viewer.place - t.a;
        shows = shows || glm::dot(glm::cross(t.b - t.a, t.c - t.a), toViewer) < 0;
    });
    return shows;
}

/// How often the surface goes around a point, counterclockwise seen from outside.
double windingNumber(const ProxyMesh& proxy, const Vec3& point) {
    double solidAngle = 0;
    forEachTriangle(proxy, [&](const Corners& t) {
        // van Oosterom, Strackee, The solid angle of a plane triangle, 1983.
        const Vec3 a = t.a - point, b = t.b - point, c = t.c - point;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        solidAngle +=
            2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                           la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    });
    return solidAngle / (4 * kPi);
}

bool isInside(const Bounds& bounds, const Vec3& point) {
    return glm::all(glm::lessThanEqual(bounds.low, point)) &&
           glm::all(glm::lessThanEqual(point, bounds.high));
}

/// Whether the plane through a point, orthogonal to `normal`, passes through the bounds.
bool cutsBounds(const Bounds& bounds, const Vec3& point, const Vec3& normal) {
    const double reach = glm::dot(0.5 * (bounds.high - bounds.low), glm::abs(normal));
    return std::abs(glm::dot(bounds.center() - point, normal)) <= reach;
}

bool showsBacks(const ProxyMesh& proxy, bool closed, const Viewer& viewer) {
    return showsAnyBack(proxy, viewer) && (!closed || seesBackFirst(proxy, viewer));
}

} // namespace

Viewer Viewer::ofCamera(const Camera& camera) {
    if (camera.projection == Camera::Projection::Perspective) return {false, camera.positionWorld};
    return {true, glm::normalize(camera.positionWorld - camera.targetWorld), true, camera.positionWorld};
}

Viewer Viewer::ofLight(const Light& light) {
    if (light.kind == Light::Kind::Point) return {false, light.positionWorld};
    return {true, light.toLightWorld};
}

bool seesBackFirst(const ProxyMesh& proxy, const Viewer& viewer) {
    Bounds bounds;
    for (const ProxyVertex& vertex : proxy.vertices)
        bounds.add(vertex.position);
    if (bounds.empty()) return false;
    if (viewer.fromPlane && cutsBounds(bounds, viewer.planePoint, viewer.place)) return true;
    double volume = 0; // times 6
    forEachTriangle(proxy, [&](const Corners& t) {
        const Vec3 center = bounds.center();
        volume += glm::dot(t.a - center, glm::cross(t.b - center, t.c - center));
    });
    const bool around = !viewer.distant && isInside(bounds, viewer.place);
    const double winding = around ? std::round(windingNumber(proxy, viewer.place)) : 0;
    const double empty = volume < 0 ? -1 : 0; // where the fronts are seen from
    return winding != empty;
}

BackSides backSidesOf(const SceneObject& object, const ProxyMesh& proxy, const Scene& scene) {
    const bool closed = isClosed(object.mesh);
    const Viewer camera = Viewer::ofCamera(scene.camera);
    BackSides sides;
    switch (object.cull) {
    case Cull::Auto:
        sides.toCamera = showsBacks(proxy, closed, camera);
        break;
    case Cull::None:
        sides.toCamera = showsAnyBack(proxy, camera);
        break;
    case Cull::Back:
        break;
    }
    sides.toLight = std::any_of(scene.lights.begin(), scene.lights.end(), [&](const Light& light) {
        return showsBacks(proxy, closed, Viewer::ofLight(light));
    });
    return sides;
}

HeightMap complementOf(const HeightMap& map) {
    std::vector<float> depths = map.depths();
    for (float& depth : depths)
        depth = 1 - depth;
    return {map.name() + " from behind", map.width(), map.height(),
            std::move(depths),           map.wrapS(), map.wrapT()};
}

} // namespace plumbline
