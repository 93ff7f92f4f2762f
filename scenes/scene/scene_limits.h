// Bounds of the values in scene files, shared by reading, writing and drafting (scenes/README.md lists all
// fields).
#pragma once

namespace plumbline {

// World units. Squared lengths are well within the range of floats.
inline constexpr double kLargestLength = 1e9;
inline constexpr double kSmallestLength = 1e-9;

inline constexpr double kSmallestFovYDegrees = 1e-3, kLargestFovYDegrees = 179.9;

inline constexpr int kMaxProxyRate = 64; // segments of the proxy per control edge

} // namespace plumbline
