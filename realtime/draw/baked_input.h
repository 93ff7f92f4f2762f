// Baked maps on the GPU: the scale an object's relief is baked at, and its texture.
#pragma once

#include "realtime/bake/bake.h"
#include "realtime/gl/gl_objects.h"
#include "scenes/surface/proxy_mesh.h"

#include <string>

namespace plumbline {

/// Mapping scales over an object's proxy, world units per unit of s and t.
struct ReliefExtents {
    Vec2 mean{0}; // 0 where the texture coordinates have no extent anywhere
    /// No way on the proxy is shorter than with these as orthogonal scales; 0 where the coordinates have no
    /// extent somewhere.
    Vec2 least{0};
};
ReliefExtents reliefExtents(const ProxyMesh& proxy);

/// The metric an object's relief is baked in. Normals are turned from scale to scale in the shader: any will
/// do, the mean one is taken. Distances must not be longer than they are anywhere: the least. Throws
/// InputError where the texture coordinates have no extent.
BakeScale bakeScale(const ReliefExtents& extents, const SceneObject& object, const std::string& kind);

/// Levels of a map of one slice in one picture: level 0 at the lower left, level k > 0 right of it at
/// height h0 - floor(h0 / 2^(k-1)) + k - 1, which is never less than the levels below it take.
BakedMap::Level packLevels(const BakedMap& map);

/// Throws MachineError if the map doesn't fit this OpenGL.
GlTexture makeBakedTexture(const BakedMap& map);

} // namespace plumbline
