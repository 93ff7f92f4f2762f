// Finds edges where a relief tears: the two faces displace the edge differently, because texture coordinates
// are discontinuous or the normals differ. Relief::seams decides how such edges are handled.
//
// World space, like the given BaseSurface.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

namespace plumbline {

struct TornEdges {
    int byMap = 0;     // offset - depth * d(st) differs
    int byNormals = 0; // n * (offset - depth * d(st)) differs because n does. An edge may count as both
};

/// Counts the torn edges of the control mesh. Edges with more than two faces compare the first face with each
/// of the others; faces without a limit surface are ignored. Displacements are compared every half texel
/// along an edge, at 32 to 2048 points; normals at 5 points, or not at all if the relief is displaced along
/// an axis. Integer jumps of texture coordinates along an axis that repeats don't tear the surface.
/// Displacements that differ by at most 1/256 of the relief's depth count as equal.
///
/// The mesh must have uvs.
TornEdges countTornEdges(const BaseSurface& surface, const Relief& relief);

/// One warning for each kind of tear: "torus: 12 edges where …". Empty without a relief. `surface` is the
/// object's base surface (makeBaseSurface).
std::vector<std::string> surfaceWarnings(const SceneObject& object, const BaseSurface& surface);

} // namespace plumbline
