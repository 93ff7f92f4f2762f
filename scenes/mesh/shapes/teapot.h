// The teapot of Martin Newell (University of Utah, 1975): 32 bicubic Bezier patches. The numbers are the
// published data set (Crow: The Origins of the Teapot, IEEE CG&A 7(1), 1987; with lid and bottom as in the
// common version, whose height is scaled by 1/1.3), written as rings of control points, which makes the
// symmetries exact: body, lid and bottom are profiles rotated around the z axis, handle and spout are half
// sections mirrored at y = 0.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <array>
#include <vector>

namespace plumbline {

inline constexpr int kMaxTeapotSegments = 64; // along a patch

/// The classic teapot (Newell 1975): its 32 bicubic Bezier patches are meshed with `segments` quads per side,
/// with coincident vertices merged, such that the limit of every vertex lies on the patches. y is up, the
/// base is at y = 0, the spout points toward +x, and the height is about 3.15. Spout and handle penetrate the
/// body without being joined to it, as in the data; the spout's mouth and the gap under the lid are open.
/// Charts, with u around and v along by arc length: body [0,4] x [0,1] upwards, bottom [0,4] x [0,1]
/// outwards, lid [0,2] x [0,1] upwards, handle [0,1] x [0,2], spout [0,1] x [0,1]. The extents are integers
/// so that maps tile, and their units have similar lengths so that the texture scale is similar everywhere.
/// Segments in [2, kMaxTeapotSegments]: with 1, a tube of two faces isn't a manifold; with 64, the poles
/// have 256 neighbors (a limit surface supports 512).
ControlMesh makeTeapot(int segments);

/// The original Bezier patches of the teapot, z up: 16 control points each, row by row. For tests.
std::vector<std::array<Vec3, 16>> teapotPatches();

} // namespace plumbline
