#include "scenes/surface/lone_corner.h"

#include <opensubdiv/sdc/crease.h>

namespace plumbline {

using namespace OpenSubdiv;

namespace {

/// Edges are collinear if the sine of their angle is below this, a few hundred times the rounding of unit
/// vectors.
constexpr double kCollinear = 0x1p-44;

} // namespace

Vec3 loneCornerNormal(const ControlMesh& mesh, const MeshFace& face, const Far::TopologyRefiner& topology,
                      size_t k) {
    const Far::TopologyLevel& level = topology.GetLevel(0);
    const Far::ConstIndexArray edges = level.GetFaceEdges(face.index);
    const size_t before = (k + face.size - 1) % face.size;
    for (const size_t side : {k, before}) // boundaries count as infinitely sharp, and non-manifold edges
        if (!Sdc::Crease::IsInfinite(level.GetEdgeSharpness(edges[static_cast<int>(side)]))) return Vec3(0);
    const Vec3& corner = mesh.pointAt(face.corner(k));
    const Vec3 next = unitOrZero(mesh.pointAt(face.corner(k + 1)) - corner),
               previous = unitOrZero(mesh.pointAt(face.corner(before)) - corner);
    const Vec3 across = glm::cross(next, previous);
    return glm::length(across) > kCollinear ? glm::normalize(across) : Vec3(0);
}

} // namespace plumbline
