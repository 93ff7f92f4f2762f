// A hit of Embree, recomputed in double from the micro-triangle it lies on.
#pragma once

#include "scenes/surface/micro_mesh.h"

namespace plumbline {

struct ResolvedHit {
    double distance;  // along the (unit) ray, world units
    Vec3 position;    // world, on the micro-triangle
    Vec3 facetNormal; // world, unit; of the micro-triangle, outward
    Vec2 uv;          // of the patch
};

/// `u`, `v`: Embree's coordinates over the grid. They name the cell but for about 1 hit in 10^4 on a border,
/// and where Embree or EmbreeScene took a ray by rounding, the ray passes beside the cell named. So where the
/// ray doesn't meet the triangle named at `distance` (Embree's), its neighbors are tried, and of them all
/// the point nearest the ray and nearest that distance is taken.
ResolvedHit resolveHit(const MicroMesh& mesh, const MicroGrid& grid, float u, float v, float distance,
                       const Ray& rayWorld);

} // namespace plumbline
