// Computes normals for meshes without normals.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// Gives every corner its vertex's normal, the mean of the face normals weighted by the face angles (Thürmer
/// and Wüthrich 1998), so that the result doesn't depend on the triangulation of polygons. Where the sum
/// cancels (coincident sheets, degenerate faces), a corner has the normal of its face, or zero if the face
/// has no area.
void addAngleWeightedNormals(ControlMesh& mesh);

} // namespace plumbline
