// Cuts faces of a control mesh into others, and drops those that can't be a face.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// Makes the vertices of each face distinct. A vertex that follows itself counts once; an edge there and back
/// (a b a) is removed; a face that still names a vertex twice, such as one with a hole that a pair of edges
/// joins to its outline, is cut into triangles. A face is dropped if fewer than three vertices are left or if
/// its outline crosses itself. Adds a warning to the mesh for each kind. A mesh whose indices are out of
/// range is left to checkControlMesh. Throws InputError if no face is left, and like cutConcaveFaces.
void repairFaces(ControlMesh& mesh);

/// Cuts faces with a concave outline (outline.h) into triangles, for Scheme::None, which would fold them:
/// quads are bilinear, and larger faces are divided around their center. Faces whose outline crosses itself
/// are dropped (mesh_defects.h warns of them). Convex faces stay as they are. The mesh must have passed
/// checkControlMesh. Throws InputError for a concave face with more than kMaxConcaveCorners corners.
void cutConcaveFaces(ControlMesh& mesh);

} // namespace plumbline
