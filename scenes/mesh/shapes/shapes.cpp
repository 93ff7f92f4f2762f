#include "scenes/mesh/shapes/shapes.h"

#include "scenes/core/error.h"
#include "scenes/mesh/shapes/limit_points.h"
#include "scenes/mesh/shapes/shape_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace plumbline {

namespace {

/// A lattice of vertices and one of uvs. The vertex lattice wraps around in the directions marked as closed;
/// `position(i, j)` is called once per distinct vertex.
template <typename Position>
ControlMesh makeLattice(std::string name, int columns, int rows, bool closedU, bool closedV,
                        Position position) {
    ControlMesh mesh;
    mesh.name = std::move(name);
    const int vertexColumns = closedU ? columns : columns + 1, vertexRows = closedV ? rows : rows + 1;
    for (int j = 0; j < vertexRows; ++j)
        for (int i = 0; i < vertexColumns; ++i)
            mesh.points.push_back(position(i, j));
    appendUvLattice(mesh, columns, rows, {0, 0}, {1, 1});
    appendQuads(
        mesh, columns, rows,
        [&](int i, int j) { return (j % vertexRows) * vertexColumns + i % vertexColumns; },
        [&](int i, int j) { return j * (columns + 1) + i; });
    return mesh;
}

/// The factor by which a closed uniform cubic B-spline shrinks its control polygon, a regular n-gon of radius
/// r: its points at knots are r (e^{-i phi} + 4 + e^{i phi}) / 6 = r (4 + 2 cos phi) / 6, phi = 2 pi / n.
double ringShrink(int segments) {
    return (4 + 2 * std::cos(2 * kPi / segments)) / 6;
}

} // namespace

ControlMesh makePlane(double width, double depth, int segmentsX, int segmentsZ) {
    requirePositive("plane", "width", width);
    requirePositive("plane", "depth", depth);
    requireSegments("plane", "segments[0]", segmentsX, 1, kMaxShapeSegments);
    requireSegments("plane", "segments[1]", segmentsZ, 1, kMaxShapeSegments);
    requireFaces("plane", int64_t(segmentsX) * segmentsZ);
    // The boundary rule also reproduces linear data, so the limit surface is exactly this rectangle with a
    // uniform parametrization.
    return makeLattice("plane", segmentsX, segmentsZ, false, false, [&](int i, int j) {
        return Vec3(width * (double(i) / segmentsX - 0.5), 0, depth * (0.5 - double(j) / segmentsZ));
    });
}

ControlMesh makeQuadric(double a, double b, double halfSize, int segments) {
    requireFinite("quadric", "a", a);
    requireFinite("quadric", "b", b);
    requirePositive("quadric", "half_size", halfSize);
    requireSegments("quadric", "segments", segments, 1, kMaxShapeSegments - 2);
    const int side = segments + 2; // with the ring that only supports the limit surface
    requireFaces("quadric", int64_t(side) * side);
    // Control values of x^2 on a uniform cubic B-spline of knot spacing h are the blossom (pq + qr + rp) / 3
    // at three successive knots, here x - h, x, x + h: x^2 - h^2/3. Those of x are x. (Ramshaw, Blossoming,
    // 1987.)
    const double h = 2 * halfSize / segments;
    const auto knot = [&](int i) { return h * (i - 1) - halfSize; };
    ControlMesh mesh = makeLattice("quadric", side, side, false, false, [&](int i, int j) {
        const double x = knot(i), y = knot(j);
        return Vec3(x, y, a * (x * x - h * h / 3) + b * (y * y - h * h / 3));
    });
    for (int j = 0, index = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i)
            item(mesh.uvs, index++) = Vec2(i - 1, j - 1) / double(segments);
    mesh.boundaryFacesSupportOnly = true;
    return mesh;
}

ControlMesh makeCylinder(double radius, double height, int segmentsAround, int segmentsUp) {
    requirePositive("cylinder", "radius", radius);
    requirePositive("cylinder", "height", height);
    requireSegments("cylinder", "segments[0]", segmentsAround, 3, kMaxShapeSegments);
    requireSegments("cylinder", "segments[1]", segmentsUp, 1, kMaxShapeSegments);
    requireFaces("cylinder", int64_t(segmentsAround) * segmentsUp);
    // Evenly spaced rows are linear along y. The boundary rule, which depends only on boundary vertices,
    // preserves this: the ends are at +-height/2 and the sides are straight.
    const double ring = radius / ringShrink(segmentsAround);
    return makeLattice("cylinder", segmentsAround, segmentsUp, true, false, [&](int i, int j) {
        const double angle = 2 * kPi * i / segmentsAround;
        return Vec3(ring * std::cos(angle), height * (double(j) / segmentsUp - 0.5), -ring * std::sin(angle));
    });
}

ControlMesh makeTorus(double major, double minor, int segmentsMajor, int segmentsMinor) {
    requirePositive("torus", "major", major);
    requirePositive("torus", "minor", minor);
    if (!(minor < major))
        throw InputError(whereOfShape("torus"), fmt::format("minor = {}", minor),
                         fmt::format("less than major = {}", major));
    requireSegments("torus", "segments[0]", segmentsMajor, 3, kMaxShapeSegments);
    requireSegments("torus", "segments[1]", segmentsMinor, 3, kMaxShapeSegments);
    requireFaces("torus", int64_t(segmentsMajor) * segmentsMinor);
    // The limit mask is the product of two ring masks: the tube's shrinks the tube toward its center line,
    // and the other one then scales the distance from the axis.
    const double tube = minor / ringShrink(segmentsMinor), ring = ringShrink(segmentsMajor);
    return makeLattice("torus", segmentsMajor, segmentsMinor, true, true, [&](int i, int j) {
        const double angle = 2 * kPi * i / segmentsMajor, tubeAngle = 2 * kPi * j / segmentsMinor;
        const double distance = (major + tube * std::cos(tubeAngle)) / ring;
        return Vec3(distance * std::cos(angle), tube * std::sin(tubeAngle), -distance * std::sin(angle));
    });
}

namespace {

/// One side of a cube with n segments per edge, in lattice coordinates [0,n]^3.
struct CubeSide {
    glm::ivec3 origin, right, up; // in edges; right x up points outwards
    Vec2 uvOrigin;
};
// The four sides around the y axis, front (+z) first, then top and bottom, whose uvs continue the front's.
constexpr CubeSide kCubeSides[6] = {
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0}},  {{1, 0, 1}, {0, 0, -1}, {0, 1, 0}, {1, 0}},
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {2, 0}}, {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {3, 0}},
    {{0, 1, 1}, {1, 0, 0}, {0, 0, -1}, {0, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0}},
};

/// Six grids with shared vertices; `position` maps a point on the cube [-1,1]^3 to its final position.
template <typename Position>
ControlMesh makeCube(std::string name, int segments, bool sidesContinueS, Position position) {
    ControlMesh mesh;
    mesh.name = std::move(name);
    std::map<std::array<int, 3>, int> vertexAt;
    const auto vertexOf = [&](const glm::ivec3& place) {
        const auto [entry, isNew] = vertexAt.try_emplace({place.x, place.y, place.z}, countOf(mesh.points));
        if (isNew) mesh.points.push_back(position(Vec3(place) * (2.0 / segments) - 1.0));
        return entry->second;
    };
    for (const CubeSide& side : kCubeSides) {
        const Vec2 low = sidesContinueS ? side.uvOrigin : Vec2(0);
        const int firstUv = appendUvLattice(mesh, segments, segments, low, low + 1.0);
        appendQuads(
            mesh, segments, segments,
            [&](int i, int j) { return vertexOf(side.origin * segments + side.right * i + side.up * j); },
            [&](int i, int j) { return firstUv + j * (segments + 1) + i; });
    }
    return mesh;
}

} // namespace

ControlMesh makeSphere(double radius, int segmentsPerCubeEdge) {
    requirePositive("sphere", "radius", radius);
    requireSegments("sphere", "segments", segmentsPerCubeEdge, 1, kMaxShapeSegments);
    requireFaces("sphere", int64_t(6) * segmentsPerCubeEdge * segmentsPerCubeEdge);
    ControlMesh mesh = makeCube("sphere", segmentsPerCubeEdge, true, [&](const Vec3& cube) {
        // Equal angles instead of equal lengths (the tangent warp) give lattice cells of nearly equal size on
        // the sphere.
        const Vec3 warped = glm::tan(cube * (kPi / 4));
        return radius * glm::normalize(warped);
    });
    interpolateLimit(mesh);
    return mesh;
}

ControlMesh makeBox(const Vec3& size, int segments) {
    requirePositive("box", "size[0]", size.x);
    requirePositive("box", "size[1]", size.y);
    requirePositive("box", "size[2]", size.z);
    requireSegments("box", "segments", segments, 1, kMaxShapeSegments);
    requireFaces("box", int64_t(6) * segments * segments);
    ControlMesh mesh = makeCube("box", segments, false, [&](const Vec3& cube) { return 0.5 * size * cube; });
    for (const CubeSide& side : kCubeSides) {
        const int normal = countOf(mesh.normals);
        mesh.normals.push_back(glm::cross(Vec3(side.right), Vec3(side.up)));
        mesh.faceNormals.insert(mesh.faceNormals.end(), 4 * areaOf(segments, segments), normal);
    }
    return mesh;
}

} // namespace plumbline
