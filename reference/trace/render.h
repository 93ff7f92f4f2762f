// Traces the frame: camera rays, hits refined to the true surface, normals and shadow rays.
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

/// Per-pixel data in addition to the frame's channels, for the certificate.
struct FrameEvidence {
    std::vector<int> face;         // of the control mesh
    std::vector<float> errorWorld; // error bound of the visible grid, world units; 0 for a miss
    /// 1: another point of the surface may be the visible one. The hit couldn't be refined, or the surface's
    /// orientation changes within the error's reach.
    std::vector<uint8_t> ambiguous;
    /// 1: another object is so close behind the visible point that it may be in front.
    std::vector<uint8_t> otherObject;
    /// Per light: how the shadow was determined.
    enum ShadowBy : uint8_t {
        kNormal,  // N.L <= 0
        kRay,     // by a ray
        kNearRay, // by a ray, but the surface may intersect it within the error's reach, or it started below
                  // micro-triangles
    };
    std::vector<std::vector<uint8_t>> shadowBy;
};

struct TracedFrame {
    Frame frame;
    FrameEvidence evidence;
};

/// Computes every channel of the table except cost and uncertain. Parallel (TBB); pixels are independent, so
/// the result doesn't depend on the number of threads.
TracedFrame traceFrame(const Scene& scene, const std::vector<TracedObject>& objects,
                       const EmbreeScene& embree);

} // namespace plumbline
