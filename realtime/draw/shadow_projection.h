// The projections of shadow maps (Williams, Casting curved shadows on curved surfaces, 1978; for reliefs
// RP-351, section 3.5).
//
// World units. A directional light has an orthographic camera fitted to the scene's bounds: one square layer,
// which stores planar distances along the light. A point light has a cube map with the world's directions +x,
// -x, +y, -y, +z, -z: six layers, which store distances from the light. On the face of axis a = ±e_i, the
// image's right is ∓e_(i+1) and its top e_(i+2), so that all six are right-handed; pointPlace of
// shadow_map.glsl selects face and position by the same rule.
#pragma once

#include "realtime/draw/view.h"

#include <vector>

namespace plumbline {

struct ShadowProjection {
    int firstLayer = 0;
    std::vector<CameraUniforms> layers; // the light as a camera: 1, or 6 for a point light
    /// Directional: (u, v) on the map in [0,1] and the distance of a position relative to the origin.
    glm::mat4 placeFromRelative{0};
    /// The scene lies between these distances, with the camera's margin (kDepthMargin).
    double nearest = 0, farthest = 1;
    /// Half a texel's diagonal perpendicular to the light's rays; for a point light at distance 1 along the
    /// axis of the cube's face.
    double halfDiagonal = 0;
    /// Bound on the rounding error of a distance.
    double rounding = 0;
};

/// One for each light. `size`: texels per side. An empty scene counts as a point at the origin.
std::vector<ShadowProjection> shadowProjections(const std::vector<Light>& lights, const Bounds& boundsWorld,
                                                const Vec3& originWorld, int size);
/// Total number of layers.
int layerCount(const std::vector<ShadowProjection>& projections);

} // namespace plumbline
