// Tests whether the true surface is front-facing or back-facing throughout a neighborhood.
#pragma once

#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"

namespace plumbline {

/// Length, along the surface, of the part of a ray that is within `errorWorld` of it, where the ray could
/// intersect the surface more than once. `cosine`: between ray and normal, either sign.
double reachAlongSurface(double errorWorld, double cosine);

/// True if P_u x P_v, times `side` (1 or -1), has a positive component along the unit vector `towardWorld`
/// everywhere within `radiusWorld` of `base`. Then a line in this direction intersects the surface there at
/// most once, and there is no self-shadowing. False if this isn't certain.
///
/// P_u x P_v = (A + k h_u) x (B + k h_v), with A and B the derivatives at constant height and k the relief's
/// direction, is linear in the map's gradient, so its minimum is at a corner of the range of gradients of the
/// surrounding texels. The variation of A, B and k is estimated from the base's curvature.
bool facesThroughout(const BaseSample& base, const Relief* relief, double radiusWorld,
                     const Vec3& towardWorld, double side);

} // namespace plumbline
