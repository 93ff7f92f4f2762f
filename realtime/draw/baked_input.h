// Baked maps on the GPU: the scale for which an object's relief is baked, and the texture.
#pragma once

#include "realtime/bake/bake.h"
#include "realtime/gl/gl_objects.h"
#include "scenes/surface/proxy_mesh.h"

#include <string>

namespace plumbline {

/// Mapping scales over an object's proxy, world units per unit of s and t.
struct ReliefExtents {
    Vec2 mean{0}; // 0 if the texture coordinates are singular everywhere
    /// Lower bound: no path on the proxy is shorter than with these as orthogonal scales; 0 if the
    /// coordinates are singular somewhere.
    Vec2 least{0};
};
ReliefExtents reliefExtents(const ProxyMesh& proxy);

/// The scale for which an object's relief is baked. Normals are converted to the local scale in the shader,
/// so any scale would do; the mean is used. Distances must be lower bounds everywhere, so the minimum is
/// used. Throws InputError if the texture coordinates are singular.
BakeScale bakeScale(const ReliefExtents& extents, const SceneObject& object, const std::string& kind);

/// Packs the levels of a map with one slice into one image: level 0 at the lower left, level k > 0 to the
/// right of it at the height h0 - floor(h0 / 2^(k-1)) + k - 1, which is at least the total height of the
/// levels below it.
BakedMap::Level packLevels(const BakedMap& map);

/// Throws MachineError if the map exceeds the limits of this OpenGL.
GlTexture makeBakedTexture(const BakedMap& map);

} // namespace plumbline
