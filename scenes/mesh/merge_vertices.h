// Vertices of a control mesh at the same place: many exporters write some for each face, so that its faces
// are loose sheets.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// The distance within which vertices count as being at the same place: 1e-6 of the mesh's size, by which
/// files of six digits or single precision round a coordinate. In the mesh's units.
double samePlaceDistance(const ControlMesh& mesh);

/// The number of boundary edges whose ends are at the same places as those of another boundary edge. The mesh
/// must have passed checkControlMesh.
size_t countEdgesOnEdges(const ControlMesh& mesh);

/// Replaces each vertex by the first one within `distance` of it that isn't replaced itself, and removes
/// those that were. Uvs and normals stay those of the corners, tags follow their vertices; creases between
/// merged vertices are removed. Faces may then name a vertex twice, which are repaired (cut_faces.h). Indices
/// must be in range. Returns the number of vertices removed.
size_t mergeVertices(ControlMesh& mesh, double distance);

} // namespace plumbline
