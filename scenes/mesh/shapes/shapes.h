// Built-in control meshes: the `shape = { kind = … }` of a scene file. All have uvs with separate indices and
// faces that are counterclockwise seen from outside. At a seam, u continues to 1 instead of returning to 0,
// so that a repeating map is continuous across the seam if its tile count is an integer.
//
// The control points of round shapes are chosen such that the Catmull-Clark limit of every vertex lies on the
// ideal shape. Between vertices the limit surface deviates by 0.12 % of the radius for cylinder and torus
// with 8 segments around, decreasing with the fourth power of the segment count. The sphere deviates by 0.24
// % with 4 segments per cube edge, decreasing with the second power because of the cube's corners.
//
// Object space, y up. All throw InputError for a size that isn't positive and finite, segments outside the
// given range, and more than kMaxShapeFaces faces.
#pragma once

#include "scenes/mesh/control_mesh.h"
#include "scenes/mesh/shapes/teapot.h"

#include <array>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr int kMaxShapeSegments = 4096; // along one direction
inline constexpr int kMaxShapeFaces = 1 << 18; // control meshes are coarse; the tessellator adds detail

/// A plane in the xz plane facing +Y, centered; uv (0,0) at (-x, +z), so that the texture isn't mirrored seen
/// from above. Segments >= 1.
ControlMesh makePlane(double width, double depth, int segmentsX, int segmentsZ);

/// z = a x^2 + b y^2 over [-halfSize, halfSize]^2, facing +z: exact as a bicubic limit surface under
/// Catmull-Clark. uv (0,0) at (-x, -y), (1,1) at (+x, +y). A ring of faces around it only supports the limit
/// surface; it would be visible under `none`. a and b may be any finite numbers; segments >= 1.
ControlMesh makeQuadric(double a, double b, double halfSize, int segments);

/// Six grids of a cube projected to a sphere; each face covers one unit square of uv. The four sides have s
/// in [0,1] (front, +z), [1,2] (+x), [2,3] and [3,4] around the y axis, with t from bottom to top, so a map
/// is seamless around them and from the front into the top and bottom faces. The other three edges of the top
/// and bottom faces are seams. Segments >= 1.
ControlMesh makeSphere(double radius, int segmentsPerCubeEdge);

/// Around Y, centered, without caps; u runs once around, counterclockwise seen from above, starting at +x,
/// and v once from bottom to top. segmentsAround >= 3, segmentsUp >= 1.
ControlMesh makeCylinder(double radius, double height, int segmentsAround, int segmentsUp);

/// Around Y; u runs once around the axis, counterclockwise seen from above, starting at +x; v once around the
/// tube, from its outermost circle upwards. minor < major; segments >= 3.
ControlMesh makeTorus(double major, double minor, int segmentsMajor, int segmentsMinor);

/// Edge lengths along x, y, z, centered; each face covers the unit square of uv, seen from outside with +y up
/// (top and bottom continue the front). The normals are face normals, so that `scheme = "none"` keeps hard
/// edges. Segments >= 1.
ControlMesh makeBox(const Vec3& size, int segments);

} // namespace plumbline
