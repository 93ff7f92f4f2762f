// Runs a search on explicitly given rays and computes their exact first hits. This tests the search without
// the rounding errors of camera and rasterizer.
#pragma once

#include "scenes/maps/height_map.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// A ray through the relief, like ReliefRay of realtime/shaders/relief_contract.glsl: st(t) = st + t
/// stTravel, d(t) = endDepth t + bend t (1 - t).
struct ReliefLine {
    glm::vec2 st, stTravel;
};
struct ReliefPath {
    float endDepth = 1, bend = 0;
    float cosine = 1; // ReliefRay::cosine
};

struct TracedHit {
    bool hit;
    double t;
    int iterations, lookups;
};

/// The hits found by `technique` ("linear_binary:linear_steps=64"), always with the line's bend, whatever
/// surface it names. Creates and releases a context.
std::vector<TracedHit> traceGlsl(const std::string& technique, const HeightMap& map,
                                 const std::vector<ReliefLine>& lines, const ReliefPath& path = {});

/// The first t in [0,1] at which the map is no deeper than the ray, in double: between crossings with lines
/// of texel centers, depth - d(t) is a quadratic, determined from three of its values.
struct TrueHit {
    double t;
    double descent;  // of depth - d(t) at t, per unit of t, >= 0; small if the ray grazes the relief
    double nearMiss; // minimum of depth - d(t) at earlier local minima; infinity if there are none
};
struct TrueTrace {
    std::optional<TrueHit> hit;
    double nearMiss; // as above, also for rays without a hit
};
TrueTrace trueFirstHit(const HeightMap& map, const ReliefLine& line, const ReliefPath& path = {});

} // namespace plumbline
