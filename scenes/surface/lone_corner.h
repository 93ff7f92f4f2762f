// Corners at which a face is alone between two sharp edges: of a boundary, or creases.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <opensubdiv/far/topologyRefiner.h>

namespace plumbline {

/// The normal of the limit surface at corner k of a face that is alone between two edges that are infinitely
/// sharp there; zero if it isn't, or if these edges are collinear. Unit, for a counterclockwise face whose
/// corner is convex.
///
/// S_u and S_v are parallel at such a corner unless it is sharp itself: both edges are parts of one smooth
/// curve (OpenSubdiv's issues 947 and 1352). With the corner v, its neighbors a and b and their mean s,
/// subdivision halves a - b, along the curve, and quarters s - v; the face's other points approach v along s
/// - v too, because they depend on it by a double eigenvalue of 1/4 (Sdc's limit tangents: (1, -1, 0) and (3,
/// 3, -6)). So the plane of v, a and b is that of the limit, for every scheme, size of the face and sharpness
/// of v.
Vec3 loneCornerNormal(const ControlMesh& mesh, const MeshFace& face,
                      const OpenSubdiv::Far::TopologyRefiner& topology, size_t k);

} // namespace plumbline
