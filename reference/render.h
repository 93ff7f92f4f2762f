// Traces the frame: camera rays, hits resolved in double, normals of the true surface, shadow rays.
#pragma once

#include "../scenes/base_surface.h"
#include "../scenes/frame.h"
#include "../scenes/scene.h"
#include "embree_scene.h"

namespace plumbline {

struct TracedObject {
    const SceneObject* object;
    const BaseSurface* surface;
    const MicroMesh* mesh;
};

struct RayCounts {
    uint64_t camera = 0, shadow = 0;
};

/// Every channel of the table but cost and uncertain. Parallel (TBB); every pixel is computed by itself, so
/// the bytes don't depend on the number of threads.
Frame renderFrame(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                  RayCounts& counts);

} // namespace plumbline
