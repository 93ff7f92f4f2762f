// Finds the space of another renderer's positions by projecting them with the camera.
#pragma once

#include "scenes/scene/camera.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace plumbline {

struct PositionSpace {
    const char* name; // for a sentence
    Mat4 worldFromTheirs;
    double medianOffsetPx; // median distance of projected positions from the centers of their pixels
};

/// The one of our world, a world with Z up and pbrt's camera space in which positions are projected closest
/// to the centers of their pixels; nullopt if no pixel is covered. `planes`: x, y, z, each a float per pixel,
/// row by row from the top; `covered`: per pixel, in the same order.
std::optional<PositionSpace> findPositionSpace(const std::array<std::span<const float>, 3>& planes,
                                               const std::vector<bool>& covered, const Camera& camera);

} // namespace plumbline
