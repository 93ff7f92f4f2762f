// Bounds of lengths in scene files.
#pragma once

namespace plumbline {

inline constexpr double kLargestLength =
    1e9; // world units: far inside what float buffers hold with their squares
inline constexpr double kSmallestLength = 1e-9;

} // namespace plumbline
