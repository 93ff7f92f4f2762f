// Traces the frame: camera rays, hits moved onto the true surface, its normals, shadow rays.
#pragma once

#include "reference/trace/embree_scene.h"
#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

#include <vector>

namespace plumbline {

struct TracedObject {
    const SceneObject* object;
    const Relief* relief; // null: none
    const BaseSurface* surface;
    const MicroMesh* mesh;
};

/// What is known of a frame's pixels beyond its channels.
struct FrameEvidence {
    std::vector<int> face;         // of the control mesh
    std::vector<float> errorWorld; // bound of the grid seen, world units; 0 on a miss
    /// 1: another place of the surface could be seen. The hit stayed on its micro-triangle, or the surface
    /// turns away within reach of the error.
    std::vector<uint8_t> unsettled;
    /// 1: another object lies so close behind the place seen that it could be in front.
    std::vector<uint8_t> otherObject;
    /// Per light: how the shadow was decided.
    enum ShadowBy : uint8_t {
        kNormal,  // N.L <= 0
        kRay,     // by a ray
        kNearRay, // by a ray, but within reach of the error the surface may rise into it, or it began beneath
                  // micro-triangles
    };
    std::vector<std::vector<uint8_t>> shadowBy;
};

struct TracedFrame {
    Frame frame;
    FrameEvidence evidence;
};

/// Every channel of the table but cost and uncertain. Parallel (TBB); every pixel is computed by itself, so
/// the bytes don't depend on the number of threads.
TracedFrame traceFrame(const Scene& scene, const std::vector<TracedObject>& objects,
                       const EmbreeScene& embree);

} // namespace plumbline
