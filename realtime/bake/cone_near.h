// The near part of a cell's cone: slopes of chords within the cell and into its eight neighbors.
//
// A chord from a point of the cell to a point less than one texel away along each axis lies in these nine
// patches. Its slope is a mean of slopes -gradient . e along its direction e, so it is bounded by the maximum
// over the gradients of the patches and the directions that lead into them. A patch's gradients are the box
// of cellSlopes, and the bounded expression is convex in the gradient, so its maximum is at a corner.
//
// Relaxed: only chords that end at an exit count. In the exit's patch the depth increases along e, so an
// earlier patch only counts for directions e in which the exit's patch can increase. On a uniform slope, no
// such chord descends.
#pragma once

#include "realtime/bake/cone_pairs.h"

namespace plumbline {

/// Upper bound of the slopes, depth per st length, of all such chords that count by the rule, if it exceeds
/// `atLeast`; otherwise `atLeast`.
double nearSlope(const HeightMap& map, const ConeRule& rule, int column, int row, int sector, double atLeast);

} // namespace plumbline
