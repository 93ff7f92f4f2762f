// A hit of Embree, recomputed in double from the micro-triangle it lies on.
#pragma once

#include "../scenes/micro_mesh.h"

namespace plumbline {

struct ResolvedHit {
    double distance;  // along the (unit) ray, world units
    Vec3 position;    // world, on the micro-triangle
    Vec3 facetNormal; // world, unit; of the micro-triangle, outward
    Vec2 uv;          // of the patch
};

/// `u`, `v`: Embree's coordinates over the grid. They name the cell but for about 1 hit in 10^4 on a border,
/// so where the ray misses the triangle named, its neighbours are tried and the hit nearest `distance`
/// (Embree's) is taken.
ResolvedHit resolveHit(const MicroMesh& mesh, const MicroGrid& grid, float u, float v, float distance,
                       const Ray& rayWorld);

} // namespace plumbline
