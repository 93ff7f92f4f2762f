// What is odd about a control mesh and still has a surface: OpenSubdiv makes one of nearly any list of
// polygons, though perhaps not the one its author had in mind.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// One line for each kind of defect, with the first place and how many more there are; the mesh's own
/// warnings first. Faces and vertices count from 1. The mesh must have passed checkControlMesh.
///
/// - Edges with three faces or more: infinitely sharp under Catmull-Clark and Loop.
/// - Neighbors that run along their edge in the same direction, so that one of them is inside out: the edge
/// is
///   infinitely sharp, its vertices are corners.
/// - Vertices where faces meet that share no edge there: corners.
/// - Faces without area, or with two vertices in one place.
/// - Closed shells whose faces look inwards.
/// - Vertices no face uses: left out.
/// - Creases and corners under Scheme::None: without effect.
std::vector<std::string> meshWarnings(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
