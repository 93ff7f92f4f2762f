// Reports defects of control meshes that are tolerated: OpenSubdiv defines a limit surface for almost any
// list of polygons, but perhaps not the intended one.
#pragma once

#include "scenes/mesh/control_mesh.h"

namespace plumbline {

/// One line for each kind of defect, with the location of the first occurrence and the number of others. The
/// mesh's own warnings come first. Faces and vertices count from 1. The mesh must have passed
/// checkControlMesh.
///
/// - Edges with three or more faces, which become infinitely sharp under Catmull-Clark and Loop.
/// - Adjacent faces with opposite orientation. Their edge becomes infinitely sharp and its ends corners.
/// - Vertices whose faces form several fans without a common edge, which become corners.
/// - Faces without area or with coincident vertices.
/// - Faces whose outline crosses itself under Scheme::None, which are left out.
/// - Closed shells whose faces point inwards.
/// - Vertices not used by any face, which are left out.
/// - Creases and corners under Scheme::None, which have no effect.
std::vector<std::string> meshWarnings(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
