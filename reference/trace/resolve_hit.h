// Recomputes a hit of Embree in double precision on its micro-triangle.
#pragma once

#include "scenes/surface/micro_mesh.h"

namespace plumbline {

struct ResolvedHit {
    double distance;  // along the (unit) ray, world units
    Vec3 position;    // world, on the micro-triangle
    Vec3 facetNormal; // world, unit; outward normal of the micro-triangle
    Vec2 uv;          // of the patch
};

/// `u`, `v`: Embree's coordinates over the grid. They identify the cell, except for about 1 hit in 10^4 at a
/// border, and for hits that Embree or EmbreeScene accepted within rounding, where the ray passes outside the
/// cell. So if the ray doesn't hit the identified triangle at Embree's `distance`, the neighboring triangles
/// are also tested, and the point closest to the ray and to that distance is used.
ResolvedHit resolveHit(const MicroMesh& mesh, const MicroGrid& grid, float u, float v, float distance,
                       const Ray& rayWorld);

} // namespace plumbline
