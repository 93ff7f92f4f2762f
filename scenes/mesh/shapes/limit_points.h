// Where the vertices of a control mesh go under Catmull-Clark, and control points for given limits: how the
// built-in shapes put their surfaces on the sphere or the Bezier patch they are named after.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// Limit of every vertex under Catmull-Clark, in the order of mesh.points; boundaries are curves that keep
/// their corners. The mesh must be manifold and oriented (the built-in shapes are).
///
/// One refinement step makes every face a quad; there the limit of a vertex of valence n is
/// (n^2 v + 4 sum(e) + sum(f)) / (n (n + 5)), e its edge neighbors, f the far corners of its quads; on a
/// boundary (e1 + 4 v + e2) / 6 (Halstead, Kass, DeRose: Efficient, Fair Interpolation using Catmull-Clark
/// Surfaces, 1993).
std::vector<Vec3> limitPoints(const ControlMesh& mesh);

/// Moves the vertices until their limits are where the vertices were, to 1e-12 of the mesh's size.
void interpolateLimit(ControlMesh& mesh);

} // namespace plumbline
