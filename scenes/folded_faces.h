// Meshes whose limit surface OpenSubdiv can't evaluate.
//
// Bfr cuts the faces around the one it evaluates out of the mesh. Where these fold back onto each other, it takes edges
// of that cutting for others: 3.5 then returns surfaces that gape along edges of the mesh, or reads and writes memory
// that isn't its own. Two situations bring that about; of 30 000 random small meshes no other had a gap or crashed:
//
// - A vertex with two faces alone between two edges, both the same two (a doublet), on a face that touches an infinitely
//   sharp or creased edge inside the mesh.
// - A triangle with a vertex of three triangles, where the edge opposite has more than two faces, or two that run along it
//   in the same direction.
#pragma once

#include "control_mesh.h"

namespace plumbline {

/// Throws InputError naming the face. For Scheme::CatmullClark and Scheme::Loop; the mesh must have passed
/// checkControlMesh.
void checkFoldedFaces(const ControlMesh& mesh);

} // namespace plumbline
