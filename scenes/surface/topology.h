// The connectivity of a control mesh as OpenSubdiv holds it. A heavy header: for base_surface.cpp alone.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

namespace plumbline {

/// Boundaries as ControlMesh::boundaryFacesSupportOnly and the tags say; Scheme::None takes no tags. Throws
/// InputError with OpenSubdiv's own words for a mesh it refuses.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> makeTopology(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
