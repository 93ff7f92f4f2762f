// Steps random rays with a cone map, as the shaders do, and counts the steps that skipped over the relief,
// which an exact traversal (relief_walk.h) detects.
//
// Relief space: s, t in map widths and heights, depth d, 0 on top and 1 deepest. No scene and no OpenGL.
#pragma once

#include "realtime/bake/baked_map.h"
#include "realtime/bake/relief_walk.h"
#include "scenes/maps/height_map.h"

#include <array>
#include <cstdint>

namespace plumbline {

/// How the ratio at st is looked up.
enum class ConeLookup {
    Cell,      // slice 1, cell that contains st
    Nearest,   // slice 0, nearest texel
    Bilinear,  // slice 0, interpolated
    MinOfFour, // slice 0, minimum of the four texels around
};

struct ConeCheck {
    /// Upper ends of the depth classes of overshoots, in relief depth; the last is 1.
    static constexpr std::array<double, 5> kDepths{1e-5, 1.0 / 1024, 1.0 / 255, 0.05, 1};
    /// Steps are counted until the ray is within this depth of the surface.
    static constexpr double kArrived = 1.0 / 1024;

    uint64_t rays = 0;
    uint64_t pierced = 0;          // rays that intersect the relief
    uint64_t overshootingRays = 0; // rays with at least one overshoot
    uint64_t overshoots = 0;
    std::array<uint64_t, kDepths.size()> overshootsByDepth{}; // one count per class of kDepths
    double deepest = 0; // largest depth below the surface on a skipped part of a ray
    DescendingRay deepestRay{};
    double deepestFrom = 0, deepestTo = 0; // the step, depths on that ray
    uint64_t arrived = 0;                  // rays that came within kArrived of the surface, or inside
    uint64_t arrivalSteps = 0;             // of these rays in total

    double meanSteps() const {
        return arrived == 0 ? 0 : static_cast<double>(arrivalSteps) / static_cast<double>(arrived);
    }
};

/// Half of the rays start at depth 0, half anywhere above the relief; slopes of 0.01 to 10 st per depth,
/// log-uniform, in all directions. A step of a conservative map overshoots if any point of it is inside the
/// relief; with `relaxed`, if it enters and leaves the relief. A ray ends at the first visited point inside
/// the relief, or if its clearance is below 1e-9. Results depend only on the seed, not on the number of
/// threads. Throws InputError for a map that isn't a cone map or has another size.
ConeCheck checkCones(const HeightMap& map, const BakedMap& cones, ConeLookup lookup, bool relaxed,
                     uint64_t rays, uint64_t seed);

} // namespace plumbline
