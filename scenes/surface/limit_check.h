// Meshes whose limit surface OpenSubdiv can't evaluate.
//
// Bfr cuts the faces around the one it evaluates out of the mesh. Where these fold back onto each other or
// several surfaces meet, it may take edges of that cutting for others: 3.5 then reads and writes memory that
// isn't its own, or returns faces that don't meet along the edge they share. Found with random meshes
// (tests/scenes/mesh/any_mesh_test.cpp).
#pragma once

#include "scenes/surface/base_surface.h"

namespace plumbline {

inline constexpr int kMostLimitEdges = 512;

/// Throws InputError naming the face:
///
/// - It has more than kMostLimitEdges vertices, or one of them as many edges. Bfr's time and memory grow with
/// their square
///   and more: a face of 500 vertices takes seconds, one of 2000 more memory than there is, a vertex of 8000
///   edges minutes.
/// - It would harm memory: two faces are the only ones between two edges, both of theirs (a doublet), and a
/// vertex of them
///   is on an edge that is creased or has more than two faces, or two that run along it in the same
///   direction.
///
/// For Scheme::CatmullClark and Scheme::Loop; the mesh must have passed checkControlMesh.
void checkLimitTopology(const ControlMesh& mesh);

/// Throws InputError naming a face that doesn't meet another one in a vertex or an edge they share, to 1e-9
/// of the mesh's size. Only faces at vertices where more than one surface meets are evaluated: elsewhere
/// Bfr's faces do meet.
void checkFacesMeet(const BaseSurface& surface);

} // namespace plumbline
