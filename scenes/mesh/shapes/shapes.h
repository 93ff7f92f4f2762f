// Built-in control meshes: the `shape = { kind = … }` of a scene file. All have uvs, outward
// counter-clockwise faces, and uv indices of their own: where a seam closes, u goes on to 1 instead of back
// to 0, so that a map that repeats is continuous across it whenever its tile count is whole.
//
// Where a shape is round, the control points are those whose Catmull-Clark limits lie on it at every vertex.
// In between the limit surface is off by 0.12 % of the radius at 8 segments around (cylinder, torus), by the
// fourth power of the segments less at more; the sphere by 0.24 % at 4 segments per cube edge, falling with
// the second power because of the cube's corners.
//
// Object space, y up. All throw InputError for a size that isn't positive and finite, segments outside the
// range named, and more than kMostShapeFaces faces.
#pragma once

#include "scenes/mesh/control_mesh.h"
#include "scenes/mesh/shapes/teapot.h"

#include <array>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr int kMostShapeSegments = 4096; // along one direction
inline constexpr int kMostShapeFaces = 1 << 18; // a cage is coarse: finer detail is the tessellator's part

/// A plane in the xz plane facing +Y, centered; uv (0,0) at (-x, +z), so that seen from above it isn't
/// mirrored. Segments >= 1.
ControlMesh makePlane(double width, double depth, int segmentsX, int segmentsZ);

/// z = a x^2 + b y^2 over [-halfSize, halfSize]^2, facing +z: exact as a bicubic limit surface under
/// Catmull-Clark. uv (0,0) at (-x, -y), (1,1) at (+x, +y). One ring of faces around it only supports the
/// limit surface; under `none` it would be visible. a and b any finite numbers; segments >= 1.
ControlMesh makeQuadric(double a, double b, double halfSize, int segments);

/// Six grids of a cube pushed out to a sphere; uv runs once over each face. The four sides take s in [0,1]
/// (front, +z), [1,2] (+x), [2,3] and [3,4] around the y axis, t from bottom to top, so a map is seamless
/// around them and, on the front, into the top and the bottom face. The other three edges of those two are
/// seams. Segments >= 1.
ControlMesh makeSphere(double radius, int segmentsPerCubeEdge);

/// Around Y, centered, without caps; u runs once around, counter-clockwise seen from above, from +x, and v
/// once from bottom to top. segmentsAround >= 3, segmentsUp >= 1.
ControlMesh makeCylinder(double radius, double height, int segmentsAround, int segmentsUp);

/// Around Y; u runs once around the axis, counter-clockwise seen from above, from +x; v once around the tube,
/// from its outermost circle upwards. minor < major; segments >= 3.
ControlMesh makeTorus(double major, double minor, int segmentsMajor, int segmentsMinor);

/// Edge lengths along x, y, z, centered; uv runs once over each face, as seen from outside with +y up (top
/// and bottom: continuing the front). Normals are the faces', so that `scheme = "none"` keeps hard edges.
/// Segments >= 1.
ControlMesh makeBox(const Vec3& size, int segments);

} // namespace plumbline
