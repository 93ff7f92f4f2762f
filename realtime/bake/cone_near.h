// The part of a cell's cone that looks no farther than a texel: within the cell and into its eight
// neighbors.
//
// A chord from a point of the cell to one less than a texel away along each axis runs through these nine
// patches alone. Its slope is a mean of slopes -gradient . e along its direction e, so no steeper than the
// steepest of them over the directions that lead from the cell into the patch. A patch's gradients fill the
// box of cellSlopes, and what is bounded is convex in the gradient: its corners decide.
//
// Relaxed: only chords that end in an exit. In the patch of the exit the depth grows along e, so a patch
// passed before counts only in directions e along which the gradient of the exit's patch can grow: on an even
// slope there are none that fall.
#pragma once

#include "realtime/bake/cone_pairs.h"

namespace plumbline {

/// At least the slope, depth per st length, of every such chord that matters by the rule, if above `atLeast`;
/// else `atLeast`.
double nearSlope(const HeightMap& map, const ConeRule& rule, int column, int row, int sector, double atLeast);

} // namespace plumbline
