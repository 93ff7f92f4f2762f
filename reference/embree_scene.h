// Micro-meshes in Embree: nearest hit and occlusion. World space; rays are float, as Embree's are.
#pragma once

#include "../scenes/micro_mesh.h"

#include <memory>
#include <optional>
#include <vector>

namespace plumbline {

class EmbreeScene {
  public:
    /// The meshes must outlive the scene: their vertices are shared, not copied. Throws MachineError on
    /// Embree's errors.
    explicit EmbreeScene(const std::vector<MicroMesh>& meshes);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    struct Hit {
        uint32_t object; // index into the meshes
        uint32_t grid;   // of that mesh
        float u, v;      // over the grid, [0,1]; not always in the right cell at a border (resolve_hit.h)
        float distance;
    };
    /// Nearest hit with distance in [0, inf). The calling thread must flush denormals (FlushDenormals).
    std::optional<Hit> intersect(const Vec3f& origin, const Vec3f& direction) const;
    /// Whether anything lies at a distance in [0, maxDistance].
    bool occluded(const Vec3f& origin, const Vec3f& direction, float maxDistance) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace plumbline
