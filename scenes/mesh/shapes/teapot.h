// The teapot of Martin Newell (University of Utah, 1975): 32 bicubic Bezier patches. The numbers are the
// published data set (Crow: The Origins of the Teapot, IEEE CG&A 7(1), 1987; the lid and bottom as in the
// version everybody uses since, scaled down in height by 1.3), rewritten as rings of control points, which
// holds every symmetry: body, lid and bottom are profiles turned about the z axis, handle and spout are half
// sections mirrored at y = 0.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <array>
#include <vector>

namespace plumbline {

inline constexpr int kMostTeapotSegments = 64; // along a patch

/// The classic teapot (Newell 1975): its 32 bicubic Bezier patches meshed with `segments` quads a side,
/// coincident vertices joined, so that limits lie on the patches at every vertex; y up, standing on y = 0,
/// spout toward +x, about 3.15 high. Spout and handle run into the body without a joint, as in the data; the
/// spout's mouth and the gap under the lid are open. Charts, u around
/// and v along by arc length: body [0,4] x [0,1] upwards, bottom [0,4] x [0,1] outwards, lid [0,2] x [0,1]
/// upwards, handle [0,1] x [0,2], spout [0,1] x [0,1]: whole numbers, so that maps close, and units of about
/// one length, so that stones are about as large everywhere. Segments in [2, kMostTeapotSegments] (at 1 a
/// tube of two faces is no manifold; at 64 the poles have 256 neighbors, and a limit surface takes 512).
ControlMesh makeTeapot(int segments);

/// Bezier patches of the teapot as they are in the data, z up: 16 control points each, row by row. For tests.
std::vector<std::array<Vec3, 16>> teapotPatches();

} // namespace plumbline
