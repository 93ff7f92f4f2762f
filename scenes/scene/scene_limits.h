// Bounds that whoever reads, writes or drafts a scene file keeps to (scenes/README.md lists all fields).
#pragma once

namespace plumbline {

// World units: far inside what float buffers hold with their squares.
inline constexpr double kLargestLength = 1e9;
inline constexpr double kSmallestLength = 1e-9;

inline constexpr double kSmallestFovYDegrees = 1e-3, kLargestFovYDegrees = 179.9;

inline constexpr int kMostProxyRate = 64; // segments of a proxy a control edge

} // namespace plumbline
