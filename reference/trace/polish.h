// A hit on a micro-triangle moved onto the surface P(u,v) it stands for.
#pragma once

#include "reference/trace/patch_neighbors.h"
#include "scenes/core/math.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"
#include "scenes/surface/displaced_surface.h"

#include <optional>

namespace plumbline {

/// The base at a place and the displaced surface over it.
struct SurfaceSample {
    BaseSample base;
    DisplacedSample displaced;
};

struct PolishedHit {
    PatchPlace place;
    double distance;      // along the (unit) ray, world units
    SurfaceSample sample; // of the surface there
};

/// Not to be shared by threads.
class Polisher {
  public:
    Polisher(const BaseSurface& surface, const Relief* relief, const PatchNeighbors& neighbors)
        : surface_(surface), relief_(relief), neighbors_(neighbors), evaluator_(surface) {}

    /// Newton's method on P(u,v) = origin + t direction, in double, from a micro-triangle's hit at `start`
    /// and `distance`. Nothing where it doesn't settle, or farther than `reachWorld` from there: at a
    /// silhouette, where the micro-triangles show what the surface hasn't, and where creases let it hop to
    /// and fro.
    std::optional<PolishedHit> polish(const Ray& rayWorld, const PatchPlace& start, double distance,
                                      double reachWorld);

    /// The first of the places the ray meets within `reachWorld` before a polished hit, or that hit: looked
    /// for from a few starts along the ray.
    PolishedHit first(const Ray& rayWorld, const PolishedHit& hit, double reachWorld);

    /// The surface at a place.
    SurfaceSample sampleAt(const PatchPlace& place);

  private:
    /// The nearest place that is in its patch.
    PatchPlace held(const PatchPlace& place) const;
    /// To other (u, v), across a side of the patch where they are outside; along the rim where nothing is
    /// beyond. False if it stands on the rim already and would go on out.
    bool move(PatchPlace& place, const Vec2& next) const;

    const BaseSurface& surface_;
    const Relief* relief_;
    const PatchNeighbors& neighbors_;
    BaseSurface::Evaluator evaluator_;
    int patch_ = -1; // the evaluator's
};

} // namespace plumbline
