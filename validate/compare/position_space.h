// Which space another renderer's positions are in, found by where the camera sees them.
#pragma once

#include "scenes/scene/camera.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace plumbline {

struct PositionSpace {
    const char* name; // as in a sentence
    Mat4 worldFromTheirs;
    double medianOffsetPx; // between where a position is seen and its pixel's center
};

/// Of our world, one with Z up, and pbrt's camera space that in which positions lie nearest to their own
/// pixels' rays; nullopt if no pixel is covered. `planes`: x, y, z, a float a pixel, row by row from the top;
/// `covered`: likewise.
std::optional<PositionSpace> findPositionSpace(const std::array<std::span<const float>, 3>& planes,
                                               const std::vector<bool>& covered, const Camera& camera);

} // namespace plumbline
