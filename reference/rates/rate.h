// Chooses the subdivision rate of each face, such that the target error is met if memory allows.
#pragma once

#include "reference/tessellate/lattice.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

#include <memory>
#include <string>
#include <vector>

namespace plumbline {

/// Peak memory in bytes per micro-triangle, including the acceleration structure; measured by `plumbline
/// bench` (Embree's grid BVH takes 8-13 bytes, vertices 12 bytes each at 17^2 per 16^2 cells).
inline constexpr double kBytesPerMicroTriangle = 20;

struct RatePlan {
    std::vector<Rates> rates; // per object
    std::vector<int> wanted;  // per object: the largest rate of a face required by the target error
    std::string limit;        // why the target error can't be met: "--memory 256 MB"; otherwise empty
    uint64_t microTriangles = 0;
};

struct PlannedObject {
    const BaseSurface* surface;
    const Relief* relief; // null: none
};

/// Measured error of the visible part of each face, in pixels; 0 if nothing is visible. Per object, per face.
using FaceErrorsPx = std::vector<std::vector<float>>;

/// Plans rates for a target error of `errorPx` within `memoryBytes`.
///
/// A face starts with cells of two texels of its relief along u and v, or at rate 1 without a relief. Then
/// the axis that gains more is doubled until the error bound (tile.h) meets the target or stops decreasing.
/// The bound is measured in all grids of the first rate; at finer rates only in the grid at the 98th
/// percentile of these, and in its worst part. For a visible face, the error is in pixels at its nearest
/// point. For a face that only casts shadows, it may be kCasterSlack times larger, in pixels at the nearest
/// visible point of the scene. Other faces stay at the smallest rate. If the plan doesn't fit into memory,
/// the target error is doubled until it does; if that isn't enough, the rates are limited, which affects the
/// largest rates first.
class RatePlanner {
  public:
    RatePlanner(const Scene& scene, std::vector<PlannedObject> objects, double errorPx, uint64_t memoryBytes);
    ~RatePlanner();
    /// Throws MachineError if even the smallest rates don't fit.
    RatePlan plan() const;
    /// Refines the faces whose measured error exceeds the target; returns false if none can be refined.
    bool refine(const FaceErrorsPx& measured);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Plans the same rate everywhere. Throws InputError for an invalid rate, MachineError if it doesn't fit.
RatePlan planUniformRate(const std::vector<PlannedObject>& objects, int rate, uint64_t memoryBytes);

} // namespace plumbline
