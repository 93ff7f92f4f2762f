// How finely each object is tessellated: one dyadic rate per object.
#pragma once

#include "../scenes/base_surface.h"
#include "../scenes/scene.h"

#include <vector>

namespace plumbline {

/// Bytes of memory a micro-triangle and a control face cost at the peak, acceleration structure included;
/// measured by `plumbline bench` (Embree's grid BVH takes 8-13 bytes, vertices 12 bytes each at 17^2 per 16^2
/// cells).
inline constexpr double kBytesPerMicroTriangle = 20;

/// Smallest power of two at which every segment of every control edge is at most half a texel and, where the
/// camera can see it, half a pixel long (as if it lay across the line of sight); at most kMaxRate, at least
/// smallestRate. Just smallestRate where that is exact: parallelograms under Scheme::None without a relief.
int wantedRate(const BaseSurface& surface, const SceneObject& object, const Camera& camera);

/// The wanted rates, halved for the object with the most micro-triangles until all fit `memoryBytes`.
/// Throws MachineError when the smallest rates don't.
std::vector<int> ratesWithinMemory(const std::vector<const BaseSurface*>& surfaces, std::vector<int> wanted,
                                   uint64_t memoryBytes);

} // namespace plumbline
