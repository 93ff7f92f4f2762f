// Steps random rays by a cone map, as the shaders do, and tells by the exact walk (relief_walk.h) which steps
// leapt over relief.
//
// Relief space: s, t in map widths and heights, depth d, 0 on top and 1 deepest. No scene and no OpenGL.
#pragma once

#include "realtime/bake/baked_map.h"
#include "realtime/bake/relief_walk.h"
#include "scenes/maps/height_map.h"

#include <array>
#include <cstdint>

namespace plumbline {

/// How a ratio is looked up at st.
enum class ConeLookup {
    Cell,      // slice 1 of the cell that holds st
    Nearest,   // slice 0, nearest texel
    Bilinear,  // slice 0, interpolated
    MinOfFour, // slice 0, least of the texels around
};

struct ConeCheck {
    /// Upper ends of the depths that leaps are sorted by, in relief depth; the last is 1.
    static constexpr std::array<double, 5> kDepths{1e-5, 1.0 / 1024, 1.0 / 255, 0.05, 1};
    /// Steps are counted until the ray is this near to the surface, measured in depth.
    static constexpr double kArrived = 1.0 / 1024;

    uint64_t rays = 0;
    uint64_t pierced = 0; // rays that met the relief
    uint64_t leaping = 0; // rays that leapt at least once
    uint64_t leaps = 0;
    std::array<uint64_t, kDepths.size()> leapsByDepth{}; // up to each of kDepths, beyond the one before
    double deepest =
        0; // how far below the surface a ray was in the part it leapt over, at most; relief depth
    DescendingRay deepestRay{};
    double deepestFrom = 0, deepestTo = 0; // the step, depths on that ray
    uint64_t arrived = 0;                  // rays that came within kArrived of the surface, or inside
    uint64_t arrivalSteps = 0;             // of them, all together

    double meanSteps() const {
        return arrived == 0 ? 0 : static_cast<double>(arrivalSteps) / static_cast<double>(arrived);
    }
};

/// Half of the rays start at depth 0, half anywhere above the relief; slopes of 0.01 to 10 st per depth,
/// log-uniform, in all directions. A step of a conservative map leaps when any point of it is inside the
/// relief; `relaxed`: when it passes a way in and out again. A ray ends at the first visited point inside.
/// Steps go on from where the last one ended; a clearance below 1e-9 ends the ray, too. The same for a seed
/// on any number of threads. Throws InputError for a map that isn't a cone map, or of another size.
ConeCheck checkCones(const HeightMap& map, const BakedMap& cones, ConeLookup lookup, bool relaxed,
                     uint64_t rays, uint64_t seed);

} // namespace plumbline
