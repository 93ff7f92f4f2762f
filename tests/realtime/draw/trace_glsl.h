// Runs a search over rays given as numbers, and finds their true first hits: the maths of a search without a
// camera, a rasterizer and their rounding.
#pragma once

#include "scenes/maps/height_map.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// A ray through the relief, as ReliefRay of realtime/shaders/relief_contract.glsl: st(t) = st + t stTravel,
/// d(t) = endDepth t + bend t (1 - t).
struct ReliefLine {
    glm::vec2 st, stTravel;
};
struct ReliefPath {
    float endDepth = 1, bend = 0;
    float cosine = 1; // what the ray says of its angle
};

struct TracedHit {
    bool hit;
    double t;
    int iterations, lookups;
};

/// What `technique` ("linear_binary:linear_steps=64") finds; always with the path's bend, whatever surface it
/// names. A context is made and given back.
std::vector<TracedHit> traceGlsl(const std::string& technique, const HeightMap& map,
                                 const std::vector<ReliefLine>& lines, const ReliefPath& path = {});

/// The first t in [0,1] at which the map is no deeper than the ray, in double: between the places where the
/// ray crosses lines of texel centers, depth - d(t) is a quadratic, known from three of its values.
struct TrueHit {
    double t;
    double descent; // of depth - d(t) at t, per unit of t, >= 0: small = the ray grazes the relief
    double
        nearMiss; // the least that depth - d(t) came down to at a turning point before, infinity if at none
};
struct TrueTrace {
    std::optional<TrueHit> hit;
    double nearMiss; // as above, for rays without a hit as well
};
TrueTrace trueFirstHit(const HeightMap& map, const ReliefLine& line, const ReliefPath& path = {});

} // namespace plumbline
