// One object's limit surface at a uniform rate, displaced: BaseSurface + Relief -> MicroMesh. World space.
#pragma once

#include "../scenes/base_surface.h"
#include "../scenes/micro_mesh.h"
#include "../scenes/scene.h"

namespace plumbline {

/// Samples are at u = i / patchRate: rates are powers of two so that they lie on OpenSubdiv's exact limit
/// points, and not above 2^10, beyond which its approximation of the limit ends.
inline constexpr int kMaxRate = 1024;

/// `rate`: a power of two, smallestRate … kMaxRate. A sample on an edge or a vertex of the control mesh is
/// computed once and shared by its faces, with the mean of their displacements and of their normals: where
/// texture coordinates tear the surface, or a crease has two normals, it is welded. `attributes`: fill
/// normals and st too. Parallel (TBB); the result doesn't depend on the number of threads.
MicroMesh tessellate(const BaseSurface& surface, const Relief* relief, int rate, bool attributes);

} // namespace plumbline
