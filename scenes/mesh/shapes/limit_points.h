// Computes the limit positions of control vertices under Catmull-Clark, and control points that interpolate
// given limits. The built-in shapes use this to make their limit surfaces interpolate the sphere, torus or
// Bezier patches.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// Limit of every vertex under Catmull-Clark, in the order of mesh.points; boundary curves have sharp
/// corners. The mesh must be manifold and oriented (the built-in shapes are).
///
/// After one refinement step every face is a quad, and the limit of a vertex of valence n is (n^2 v + 4
/// sum(e) + sum(f)) / (n (n + 5)), with e its edge neighbors and f the opposite corners of its quads; on a
/// boundary it is (e1 + 4 v + e2) / 6 (Halstead, Kass, DeRose: Efficient, Fair Interpolation using
/// Catmull-Clark Surfaces, 1993).
std::vector<Vec3> limitPoints(const ControlMesh& mesh);

/// Moves the vertices so that their limits are the original vertex positions, to 1e-12 of the mesh's size.
void interpolateLimit(ControlMesh& mesh);

} // namespace plumbline
