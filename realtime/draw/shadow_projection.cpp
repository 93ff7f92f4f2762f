#include "realtime/draw/shadow_projection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

// Extents are at least this fraction of the scene's diagonal: a flat scene seen along its plane has no
// extent.
constexpr double kSmallestExtent = 1e-6;
// Margin of the clip planes in front of and behind the scene. It doesn't affect the stored distances.
constexpr double kClipMargin = 1e-3;
// Near plane of a cube face as a fraction of the far plane, as for the camera (view.cpp).
constexpr double kNearFraction = 1e-6;
// Relative rounding error: about a dozen float operations from a vertex to a distance, each accurate to 2^-24
// of its operands.
constexpr double kRounding = 0x1p-20;

std::array<Vec3, 8> corners(const Bounds& bounds) {
    std::array<Vec3, 8> points;
    for (unsigned i = 0; i < 8; ++i)
        points[i] = Vec3(i & 1u ? bounds.high.x : bounds.low.x, i & 2u ? bounds.high.y : bounds.low.y,
                         i & 4u ? bounds.high.z : bounds.low.z);
    return points;
}

struct Interval {
    double low = kInfinity, high = -kInfinity;
    double extent() const { return high - low; }
};

/// The extent of the bounds along a direction, at least `least` wide.
Interval intervalAlong(const Vec3& direction, const Bounds& bounds, double least) {
    Interval interval;
    for (const Vec3& corner : corners(bounds)) {
        interval.low = std::min(interval.low, glm::dot(direction, corner));
        interval.high = std::max(interval.high, glm::dot(direction, corner));
    }
    const double missing = 0.5 * std::max(least - interval.extent(), 0.0);
    return {interval.low - missing, interval.high + missing};
}

/// Builds a matrix from rows: matrix * (p, 1) = (dot(row.xyz, p) + row.w, …).
glm::mat4 matrixOfRows(const Vec4& x, const Vec4& y, const Vec4& z, const Vec4& w) {
    return glm::mat4(glm::transpose(Mat4(x, y, z, w)));
}

/// The row that maps p - origin to (dot(direction, p) - low) * scale + offset.
Vec4 rowAlong(const Vec3& direction, const Vec3& originWorld, double low, double scale, double offset) {
    return {direction * scale, (glm::dot(direction, originWorld) - low) * scale + offset};
}

/// The image axes for which the bounding rectangle is smallest. The box's outline is a hexagon whose sides
/// are projections of the world axes, and the smallest rectangle around a convex polygon has a side collinear
/// with one of the polygon's.
struct PictureAxes {
    Vec3 right, up;
};
PictureAxes smallestPicture(const Vec3& toLight, const Bounds& bounds) {
    PictureAxes best{};
    double smallest = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 along(0);
        along[axis] = 1;
        const Vec3 across = along - toLight * toLight[axis];
        if (glm::length(across) < 1e-3)
            continue; // the light is parallel to this axis, whose projection is a point
        const Vec3 right = glm::normalize(across), up = glm::cross(toLight, right);
        const double area = intervalAlong(right, bounds, 0).extent() * intervalAlong(up, bounds, 0).extent();
        if (area < smallest) {
            smallest = area;
            best = {right, up};
        }
    }
    return best;
}

ShadowProjection directionalProjection(const Vec3& toLight, const Bounds& bounds, const Vec3& originWorld,
                                       int size) {
    const double least = bounds.diagonal() > 0 ? kSmallestExtent * bounds.diagonal() : 1.0;
    const auto [right, up] = smallestPicture(toLight, bounds);
    const Vec3 forward = -toLight;
    const Interval u = intervalAlong(right, bounds, least), v = intervalAlong(up, bounds, least),
                   distance = intervalAlong(forward, bounds, least);
    const double front = distance.low - kClipMargin * distance.extent(),
                 depth = (1 + 2 * kClipMargin) * distance.extent();
    const Vec4 distanceRow = rowAlong(forward, originWorld, 0, 1, 0), last(0, 0, 0, 1);

    ShadowProjection light;
    light.nearest = distance.low - kDepthMargin * bounds.diagonal();
    light.farthest = distance.high + kDepthMargin * bounds.diagonal();
    light.placeFromRelative =
        matrixOfRows(rowAlong(right, originWorld, u.low, 1 / u.extent(), 0),
                     rowAlong(up, originWorld, v.low, 1 / v.extent(), 0), distanceRow, last);
    light.halfDiagonal = 0.5 * std::hypot(u.extent(), v.extent()) / size;
    light.rounding = kRounding * std::max(bounds.diagonal(), least);
    CameraUniforms camera;
    camera.clipFromRelative = matrixOfRows(rowAlong(right, originWorld, u.low, 2 / u.extent(), -1),
                                           rowAlong(up, originWorld, v.low, 2 / v.extent(), -1),
                                           rowAlong(forward, originWorld, front, 2 / depth, -1), last);
    camera.eye = glm::vec4(glm::vec3(toLight), 0);
    camera.depthPlane = glm::vec4(distanceRow);
    light.layers = {camera};
    return light;
}

/// One face of a point light's cube.
CameraUniforms faceCamera(const Vec3& positionRelative, int axis, double sign, double farthest) {
    Vec3 forward(0), right(0), up(0);
    forward[axis] = sign;
    right[(axis + 1) % 3] = -sign;
    up[(axis + 2) % 3] = 1;
    const auto row = [&](const Vec3& direction) {
        return Vec4(direction, -glm::dot(direction, positionRelative));
    };
    const double far = (1 + kClipMargin) * farthest, near = kNearFraction * far;
    CameraUniforms camera;
    camera.clipFromRelative = matrixOfRows(row(right), row(up),
                                           row(forward) * ((far + near) / (far - near)) -
                                               Vec4(0, 0, 0, 2 * far * near / (far - near)),
                                           row(forward));
    camera.eye = glm::vec4(glm::vec3(positionRelative), 1);
    camera.depthPlane = glm::vec4(row(forward));
    return camera;
}

ShadowProjection pointProjection(const Vec3& position, const Bounds& bounds, const Vec3& originWorld,
                                 int size) {
    ShadowProjection light;
    const Vec3 nearestPoint = glm::clamp(position, bounds.low, bounds.high);
    light.nearest = glm::length(nearestPoint - position);
    light.farthest = 0;
    for (const Vec3& corner : corners(bounds))
        light.farthest = std::max(light.farthest, glm::length(corner - position));
    light.nearest = std::max(light.nearest - kDepthMargin * bounds.diagonal(), 0.0);
    light.farthest += kDepthMargin * bounds.diagonal();
    if (!(light.farthest > light.nearest)) light.farthest = light.nearest + 1; // the scene is a single point
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            light.layers.push_back(faceCamera(position - originWorld, axis, sign, light.farthest));
    light.halfDiagonal = std::sqrt(2.0) / size; // a face is 2 wide at distance 1
    light.rounding = kRounding * (bounds.diagonal() + light.farthest);
    return light;
}

} // namespace

std::vector<ShadowProjection> shadowProjections(const std::vector<Light>& lights, const Bounds& boundsWorld,
                                                const Vec3& originWorld, int size) {
    Bounds bounds = boundsWorld;
    if (bounds.empty()) bounds.add(originWorld);
    std::vector<ShadowProjection> projections;
    int layer = 0;
    for (const Light& light : lights) {
        ShadowProjection& projection = projections.emplace_back(
            light.kind == Light::Kind::Directional
                ? directionalProjection(light.toLightWorld, bounds, originWorld, size)
                : pointProjection(light.positionWorld, bounds, originWorld, size));
        projection.firstLayer = layer;
        for (CameraUniforms& camera : projection.layers)
            camera.depthRange = glm::vec2(projection.nearest, 1 / (projection.farthest - projection.nearest));
        layer += static_cast<int>(projection.layers.size());
    }
    return projections;
}

int layerCount(const std::vector<ShadowProjection>& projections) {
    return projections.empty()
               ? 0
               : projections.back().firstLayer + static_cast<int>(projections.back().layers.size());
}

} // namespace plumbline
