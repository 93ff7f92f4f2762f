// Tessellates the displaced surface of one object at given rates: BaseSurface + Relief -> MicroMesh. World
// space.
#pragma once

#include "reference/tessellate/lattice.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"
#include "scenes/surface/micro_mesh.h"

namespace plumbline {

/// Vertices shared by patches are computed once (shared_vertices.h). `attributes`: also compute normals and
/// st. Parallel (TBB); the result doesn't depend on the number of threads.
MicroMesh tessellate(const BaseSurface& surface, const Relief* relief, const Rates& rates, bool attributes);

} // namespace plumbline
