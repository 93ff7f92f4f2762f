// Where a straight ray is inside the bilinear relief: exactly, cell by cell, by the roots of a quadratic;
// nothing is marched.
//
// Relief space: s, t in map widths and heights, depth d, 0 on top and 1 deepest. Inside: d > D(s, t). No base
// surface, no camera.
#pragma once

#include "scenes/maps/height_map.h"

#include <vector>

namespace plumbline {

/// (s, t) at depth d is origin + d * slope: a ray that descends, told by its depth.
struct DescendingRay {
    Vec2 origin; // st at depth 0
    Vec2 slope;  // st per unit of depth
    Vec2 at(double depth) const { return origin + depth * slope; }
};

/// Depths between which the ray is inside.
struct InsideInterval {
    double begin, end;
    double deepest; // largest d - D in between
};

/// The intervals within [begin, end] in order, each as long as it can be. Good to a few 1e-16 in depth:
/// intervals that a rounding error would close are joined, those with no positive depth left out.
void walkRelief(const HeightMap& map, const DescendingRay& ray, double begin, double end,
                std::vector<InsideInterval>& intervals);

} // namespace plumbline
