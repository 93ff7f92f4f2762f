// How finely each object is tessellated: by face, as finely as the error aimed at asks for, as coarsely as
// memory allows.
#pragma once

#include "reference/tessellate/lattice.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

#include <memory>
#include <string>
#include <vector>

namespace plumbline {

/// Bytes of memory a micro-triangle costs at the peak, acceleration structure included; measured by
/// `plumbline bench` (Embree's grid BVH takes 8-13 bytes, vertices 12 bytes each at 17^2 per 16^2 cells).
inline constexpr double kBytesPerMicroTriangle = 20;

struct RatePlan {
    std::vector<Rates> rates; // per object
    std::vector<int> wanted;  // per object: the largest rate of a face the aim asks for
    std::string limit;        // why the aim isn't planned for: "--memory 256 MB"; empty if it is
    uint64_t microTriangles = 0;
};

struct PlannedObject {
    const BaseSurface* surface;
    const Relief* relief; // null: none
};

/// What a run measured: the error of what is seen of each face, px; 0 where nothing is. Per object, per face.
using FaceErrorsPx = std::vector<std::vector<float>>;

/// Plans rates for an error of `errorPx`, all within `memoryBytes`.
///
/// A face begins at two texels of its relief a cell, along u and along v, or at 1 without one; then the axis
/// that gains more is doubled until the error bound (tile.h) is at most the aim, or falls no more. It is
/// measured in all the grids of the first rate; at finer ones within the grid that all but 2 % of those don't
/// exceed, and its worst part. It counts in pixels at the face's nearest place, for a face that is seen. One
/// that only casts shadows may be kCasterSlack times worse, in pixels of the nearest place of anything seen;
/// one that does neither stays at the smallest rate. If that doesn't fit, the aim is doubled until it does;
/// then texels are given up, the largest faces first.
class RatePlanner {
  public:
    RatePlanner(const Scene& scene, std::vector<PlannedObject> objects, double errorPx, uint64_t memoryBytes);
    ~RatePlanner();
    /// Throws MachineError when the smallest rates don't fit.
    RatePlan plan() const;
    /// Makes the faces finer that a run found above the aim; false if there is none that can be.
    bool refine(const FaceErrorsPx& measured);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The same rate everywhere. Throws InputError for a rate that is none, MachineError if it doesn't fit.
RatePlan planUniformRate(const std::vector<PlannedObject>& objects, int rate, uint64_t memoryBytes);

} // namespace plumbline
