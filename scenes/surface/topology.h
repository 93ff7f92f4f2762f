// The connectivity of a control mesh in OpenSubdiv's representation. Few files include it, because
// OpenSubdiv is expensive to compile.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

namespace plumbline {

/// Boundaries follow ControlMesh::boundaryFacesSupportOnly and the tags; Scheme::None ignores tags. Throws
/// InputError with OpenSubdiv's message for a mesh that it rejects.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> makeTopology(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
