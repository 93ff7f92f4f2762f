// Edges where a relief tears: the two faces disagree about the displaced point, because texture coordinates
// jump between them or because each has a normal of its own. What becomes of the surface there is
// Relief::seams.
//
// World space, like the BaseSurface given.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

namespace plumbline {

struct TornEdges {
    int byMap = 0;     // offset - depth * d(st) differs
    int byNormals = 0; // n * (offset - depth * d(st)) differs, were the map continuous. An edge may be both
};

/// Edges of the control mesh with two faces (or more: the first is held against each other one). Faces
/// without a limit surface don't count. Places along an edge that are compared: for the map every half texel,
/// 32 to 2048 of them; for normals 5, and none where the relief goes along an axis. Texture coordinates that
/// jump by whole numbers along an axis that repeats aren't looked at: they tear nothing. Two displacements
/// count as one up to 1/256 of the relief's depth.
///
/// The mesh must have uvs.
TornEdges countTornEdges(const BaseSurface& surface, const Relief& relief);

/// A line for each kind of tear the object has: "torus: 12 edges where …". None without a relief. `surface`
/// is that of the object (makeBaseSurface).
std::vector<std::string> surfaceWarnings(const SceneObject& object, const BaseSurface& surface);

} // namespace plumbline
