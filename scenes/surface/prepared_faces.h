// Faces of a subdivision surface, prepared for evaluation. Preparing an irregular face combines all control
// points around it into hundreds of patch points, whose number and cost grow with the square of the valence
// (0.5 ms for a vertex of 128 edges), so such faces are kept and shared by threads.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/bfr/surfaceFactory.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace plumbline {

struct PreparedFace {
    OpenSubdiv::Bfr::Surface<double> surface;
    std::vector<double> patchPoints; // xyz, world
    double largestCoordinate = 0;    // of the patch points
    uint64_t bytes() const { return patchPoints.size() * sizeof(double); }
};

/// Of all faces kept. Enough for those around a vertex of kMaxLimitEdges edges (limit_check.h). Further faces
/// are prepared whenever they are needed.
inline constexpr uint64_t kMaxKeptBytes = 160 << 20;

/// Thread-safe.
class PreparedFaces {
  public:
    /// Keeps references to both.
    PreparedFaces(const OpenSubdiv::Bfr::SurfaceFactory& factory, const ControlMesh& mesh);

    /// Throws InputError naming the face if OpenSubdiv can't evaluate it.
    std::shared_ptr<const PreparedFace> face(int index);

  private:
    std::shared_ptr<const PreparedFace> prepare(int index) const;
    void keep(int index, const std::shared_ptr<const PreparedFace>& prepared);

    const OpenSubdiv::Bfr::SurfaceFactory& factory_;
    const ControlMesh& mesh_;
    std::vector<std::atomic<std::shared_ptr<const PreparedFace>>> kept_; // per face, or null
    std::atomic<uint64_t> keptBytes_ = 0;
};

} // namespace plumbline
