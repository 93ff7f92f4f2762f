// Refines a hit on a micro-triangle to a hit on the true surface P(u,v).
#pragma once

#include "reference/trace/patch_neighbors.h"
#include "scenes/core/math.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"
#include "scenes/surface/displaced_surface.h"

#include <optional>

namespace plumbline {

/// The base and the displaced surface at the same parameter values.
struct SurfaceSample {
    BaseSample base;
    DisplacedSample displaced;
};

struct RefinedHit {
    PatchPlace place;
    double distance;      // along the (unit) ray, world units
    SurfaceSample sample; // of the surface at the hit
};

/// Not thread-safe.
class HitRefiner {
  public:
    HitRefiner(const BaseSurface& surface, const Relief* relief, const PatchNeighbors& neighbors)
        : surface_(surface), relief_(relief), neighbors_(neighbors), evaluator_(surface) {}

    /// Newton's method on P(u,v) = origin + t direction, in double, from a micro-triangle's hit at `start`
    /// and `distance`. Returns nothing if the iteration doesn't converge or leaves the distance `reachWorld`.
    /// This happens at silhouettes, where the ray may hit the micro-triangles but not the surface, and if the
    /// iteration oscillates between creases.
    std::optional<RefinedHit> refine(const Ray& rayWorld, const PatchPlace& start, double distance,
                                     double reachWorld);

    /// The first intersection of the ray with the surface within `reachWorld` before a refined hit, or that
    /// hit. Searches from several starting points along the ray.
    RefinedHit first(const Ray& rayWorld, const RefinedHit& hit, double reachWorld);

    /// Evaluates the surface.
    SurfaceSample sampleAt(const PatchPlace& place);

  private:
    /// Clamps a place to its patch.
    PatchPlace clamped(const PatchPlace& place) const;
    /// Moves a place to other (u, v), which may be in a neighboring patch. At a boundary it is clamped;
    /// returns false if it is already at the boundary and would leave it.
    bool move(PatchPlace& place, const Vec2& next) const;

    const BaseSurface& surface_;
    const Relief* relief_;
    const PatchNeighbors& neighbors_;
    BaseSurface::Evaluator evaluator_;
    int patch_ = -1; // current patch of the evaluator
};

} // namespace plumbline
