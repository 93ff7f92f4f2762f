// One object's limit surface at a uniform rate, displaced: BaseSurface + Relief -> MicroMesh. World space.
#pragma once

#include "../scenes/base_surface.h"
#include "../scenes/micro_mesh.h"
#include "../scenes/scene.h"

namespace plumbline {

/// Samples are at u = i / patchRate: rates are powers of two so that they lie on OpenSubdiv's exact limit
/// points, and not above 2^10, beyond which its approximation of the limit ends.
inline constexpr int kMaxRate = 1024;

/// Segments along one side of a patch at `rate` segments per control edge: half of it for a sub-face.
inline int patchRate(const BaseSurface::Patch& patch, int rate) {
    return patch.subFace ? rate / 2 : rate;
}

/// Smallest rate the mesh can have: 2 if a face is split into sub-faces, else 1.
int smallestRate(const BaseSurface& surface);

/// Micro-triangles and vertices at a rate, without making them.
struct MicroMeshSize {
    uint64_t microTriangles = 0;
    uint64_t vertices = 0;
    uint64_t grids = 0;
};
MicroMeshSize microMeshSize(const BaseSurface& surface, int rate);

/// `rate`: a power of two, smallestRate … kMaxRate. A sample on an edge or a vertex of the control mesh is
/// computed once and shared by its faces, with the mean of their displacements and of their normals: where
/// texture coordinates tear the surface, or a crease has two normals, it is welded. `attributes`: fill
/// normals and st too. Parallel (TBB); the result doesn't depend on the number of threads.
MicroMesh tessellate(const BaseSurface& surface, const Relief* relief, int rate, bool attributes);

} // namespace plumbline
