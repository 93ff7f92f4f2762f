// Detects meshes whose limit surface OpenSubdiv can't evaluate.
//
// Bfr extracts the neighborhood of each face that it evaluates. If faces of a neighborhood fold back onto
// each other or several surfaces meet there, Bfr may confuse their edges: version 3.5 then accesses memory
// out of bounds, or returns faces that don't meet along a shared edge. Found with random meshes
// (tests/scenes/mesh/any_mesh_test.cpp).
#pragma once

#include "scenes/surface/base_surface.h"

namespace plumbline {

inline constexpr int kMaxLimitEdges = 512;

/// Throws InputError naming the face if
///
/// - it has more than kMaxLimitEdges vertices, or one of its vertices has more edges. Bfr's time and memory
///   grow at least quadratically: a face of 500 vertices takes seconds, one of 2000 exhausts the memory, and
///   a vertex of 8000 edges takes minutes.
/// - Bfr would access memory out of bounds: two faces are the only ones at two consecutive edges, which both
///   share (a doublet), and one of their vertices is on an edge that is creased, has more than two faces, or
///   is traversed by two faces in the same direction.
///
/// For Scheme::CatmullClark and Scheme::Loop; the mesh must have passed checkControlMesh.
void checkLimitTopology(const ControlMesh& mesh);

/// Throws InputError naming a face that doesn't meet another one at a shared vertex or edge to within 1e-9 of
/// the mesh's size. Only faces at non-manifold vertices are evaluated, because Bfr's faces meet everywhere
/// else.
void checkFacesMeet(const BaseSurface& surface);

} // namespace plumbline
