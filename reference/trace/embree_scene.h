// Nearest-hit and occlusion queries on micro-meshes with Embree. World space, world units; rays are float,
// like Embree's, with unit directions.
//
// Embree's ROBUST mode finds all hits inside micro-triangles and on their edges, but 1 to 2 % of rays aimed
// exactly at a vertex leak through the surface. Such rays are retraced with a small offset (LeakGuard). One
// case isn't detected: a ray that starts inside a closed surface, exits exactly through a vertex and then
// hits the outer side of another surface.
#pragma once

#include "scenes/surface/micro_mesh.h"

#include <memory>
#include <optional>
#include <vector>

namespace plumbline {

/// Whether rays that may have leaked between micro-triangles are retraced. Off is for measurements of Embree
/// alone.
enum class LeakGuard { Off, On };

class EmbreeScene {
  public:
    /// The meshes must outlive the scene: their vertices are shared, not copied. `culled`: per mesh, whether
    /// intersectSeen skips its back sides; empty: none. Throws MachineError on Embree's errors.
    explicit EmbreeScene(const std::vector<MicroMesh>& meshes, LeakGuard guard = LeakGuard::On,
                         const std::vector<bool>& culled = {});
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// Largest absolute coordinate of all vertices, world units.
    float largestCoordinate() const;

    struct Hit {
        uint32_t object; // index into the meshes
        uint32_t grid;   // of that mesh
        float u, v;      // over the grid, [0,1]; not always in the right cell at a border (resolve_hit.h)
        float distance;
    };
    /// Nearest hit with distance in [0, inf). A retraced ray returns the hit of an offset ray, from which
    /// resolveHit computes the ray's own hit. The calling thread must flush denormals (FlushDenormals).
    std::optional<Hit> intersect(const Vec3f& origin, const Vec3f& direction) const;
    /// The same as the camera sees it: without the back sides of culled meshes.
    std::optional<Hit> intersectSeen(const Vec3f& origin, const Vec3f& direction) const;
    /// Whether there is a hit with distance in [0, maxDistance].
    bool occluded(const Vec3f& origin, const Vec3f& direction, float maxDistance) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace plumbline
