// Micro-meshes in Embree: nearest hit and occlusion. World space, world units; rays are float, as Embree's
// are, and their directions unit.
//
// Embree's ROBUST mode finds every hit inside a micro-triangle and on its edges, but a ray aimed at a vertex
// to the last bit slips through 1 or 2 times in 100. Here such rays are traced again a little beside
// (LeakGuard). What that can't notice: a ray that starts inside a closed surface, leaves through a vertex and
// then meets the outer side of something else.
#pragma once

#include "scenes/surface/micro_mesh.h"

#include <memory>
#include <optional>
#include <vector>

namespace plumbline {

/// Whether rays that may have slipped between micro-triangles are traced again. Off is Embree alone: for
/// measuring.
enum class LeakGuard { Off, On };

class EmbreeScene {
  public:
    /// The meshes must outlive the scene: their vertices are shared, not copied. Throws MachineError on
    /// Embree's errors.
    explicit EmbreeScene(const std::vector<MicroMesh>& meshes, LeakGuard guard = LeakGuard::On);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Largest coordinate of a vertex, either sign; world units.
    float largestCoordinate() const;

    struct Hit {
        uint32_t object; // index into the meshes
        uint32_t grid;   // of that mesh
        float u, v;      // over the grid, [0,1]; not always in the right cell at a border (resolve_hit.h)
        float distance;
    };
    /// Nearest hit with distance in [0, inf). A ray that had to be traced again reports the hit of its
    /// neighbor: resolveHit finds its own. The calling thread must flush denormals (FlushDenormals).
    std::optional<Hit> intersect(const Vec3f& origin, const Vec3f& direction) const;
    /// Whether anything lies at a distance in [0, maxDistance].
    bool occluded(const Vec3f& origin, const Vec3f& direction, float maxDistance) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace plumbline
