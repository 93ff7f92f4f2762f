// The exact frame of a scene: tessellate the limit surface, displace it, trace it (Embree), resolve every hit
// in double.
//
// World space and world units throughout. Never includes realtime/.
#pragma once

#include "scenes/frame/certificate.h"
#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/micro_mesh.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace plumbline {

struct ReferenceOptions {
    Base base = Base::Limit;
    /// Aim of the certificate: the 99th percentile of the micro-triangles' distance from the true surface, in
    /// pixels.
    double errorPx = 0.05;
    /// Segments per control edge, a power of two in [1, 1024], the same for all; 0 = chosen, face by face.
    int rate = 0;
    /// Budget of micro-triangles and their acceleration structure together; 0 = half of what is free.
    uint64_t memoryBytes = 0;
    /// Also fill normals and st of the micro-meshes.
    bool microAttributes = false;
};

struct ReferenceStats {
    Certificate certificate; // of the last render()
    uint64_t microTriangles = 0;
    double tessellateMs = 0, buildMs = 0, traceMs = 0, certifyMs = 0;
    struct Object {
        std::string name;
        int rate;       // segments per control edge, the most of a face
        int wantedRate; // the most a face would have had for the error aimed at
        uint64_t microTriangles;
    };
    std::vector<Object> objects;
    std::vector<std::string> warnings; // a line each: where a relief tears the surface
};

/// Tessellated and displaced objects with their acceleration structure.
class ReferenceScene {
  public:
    /// Throws InputError for a scene that can't be tessellated, MachineError if not even rate 1 fits the
    /// budget.
    ReferenceScene(const Scene& scene, const ReferenceOptions& options);
    ~ReferenceScene();
    ReferenceScene(ReferenceScene&&) noexcept;

    /// One micro-mesh per object, in the scene's order. The floats Embree traces.
    const std::vector<MicroMesh>& microMeshes() const;
    /// Every channel of the table but cost.
    Frame render();
    const ReferenceStats& stats() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace plumbline
