// Computes where a straight ray is inside the bilinear relief, exactly: cell by cell, from the roots of a
// quadratic, without ray marching.
//
// Relief space: s, t in map widths and heights, depth d, 0 on top and 1 deepest. Inside: d > D(s, t). No base
// surface, no camera.
#pragma once

#include "scenes/maps/height_map.h"

#include <vector>

namespace plumbline {

/// (s, t) at depth d is origin + d * slope: a descending ray parametrized by its depth.
struct DescendingRay {
    Vec2 origin; // st at depth 0
    Vec2 slope;  // st per unit of depth
    Vec2 at(double depth) const { return origin + depth * slope; }
};

/// An interval of depths in which the ray is inside.
struct InsideInterval {
    double begin, end;
    double deepest; // maximum of d - D in the interval
};

/// The maximal intervals within [begin, end], in order. Accurate to a few 1e-16 in depth: intervals separated
/// by less than a rounding error are merged, and intervals without positive depth are left out.
void walkRelief(const HeightMap& map, const DescendingRay& ray, double begin, double end,
                std::vector<InsideInterval>& intervals);

} // namespace plumbline
