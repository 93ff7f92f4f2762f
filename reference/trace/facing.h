// Whether the true surface turns one side to a viewer, or a light, all around a place.
#pragma once

#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"

namespace plumbline {

/// Along the surface, the part of a ray that is within `errorWorld` of it: there the surface could be met
/// more than once. `cosine`: between ray and normal, either sign.
double reachAlongSurface(double errorWorld, double cosine);

/// True if P_u x P_v, times `side` (1 or -1), has a positive component along the unit vector `towardWorld`
/// everywhere within `radiusWorld` of the place of `base`: then a line along it meets the surface there at
/// most once, and the surface doesn't shadow itself. False where that isn't certain.
///
/// P_u x P_v = (A + k h_u) x (B + k h_v), with A and B the derivatives at constant height and k the relief's
/// direction, is linear in the map's gradient: it is smallest at a corner of the box of gradients the texels
/// around have. A, B and k are taken to turn with the base's curvature.
bool facesThroughout(const BaseSample& base, const Relief* relief, double radiusWorld,
                     const Vec3& towardWorld, double side);

} // namespace plumbline
