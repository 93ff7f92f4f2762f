// Normals for meshes that have none.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// Gives every corner the normal of its vertex: face normals weighted by the angle of the face there (Thürmer
/// and Wüthrich 1998), so that the result doesn't depend on how a polygon is cut into triangles.
/// Where they cancel (two sheets back to back, faces with vertices in one place) a corner has its own face's
/// normal; zero in a face without area.
void addAngleWeightedNormals(ControlMesh& mesh);

} // namespace plumbline
