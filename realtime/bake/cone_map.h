// Cone maps: how far a ray may go from above a place of the relief before the relief can stop it.
//
// Texture space: lengths in st units (map widths and heights), relief depth d, 0 on top and 1 deepest. A
// ratio c is st length per unit of depth, at most 1 (Policarpo, Oliveira, "Relaxed cone stepping for relief
// mapping", GPU Gems 3, chapter 18, 2007): the cone over x holds the points within c (D(x) - d) of x at depth
// d. What is claimed of the bilinear surface D:
//   cone_step, cone_step_quad   no point of the relief is inside (quad: inside the quadrant of the cone)
//   cone_step_relaxed           a descending ray that starts its step over x, outside, doesn't leave the
//   relief inside the cone, so that
//                               it enters once at most
//   cone_step_relaxed_2007      the same of rays that start at depth 0 over x alone, as chapter 18 has it
//
// Slice 0 holds for each texel center p the documents' ratio, to the other texel centers: c = min |q - p| /
// (D_p - D_q) over higher q that matter. Relaxed: a descending ray leaves at q only if D grows outward there,
// which S > 0 says of texels, S = |k_s| (D(q + e_s) - D_q) + |k_t| (D(q + e_t) - D_q), k = q - p and e
// outward unit steps. 2007: S / |k| is the relief's slope along the ray at q, D_q / |k| that of the ray from
// depth 0 over p through q, both in depth per texel: it leaves there exactly if S > D_q. That decides by one
// comparison what the listing marches for, in 128 steps.
//
// Slice 1 holds for each cell (i, j), the patch between texels (i, j) and (i + 1, j + 1), one ratio right for
// every point of it. Let lambda = 1 / c; wanted is D(x) - D(y) <= lambda |x - y| for x in the cell and y
// anywhere.
//   Far. D(x) is the mean of D_i over the corners i of x's cell, each axis choosing its upper one with the
//   fractional place as probability; so is D(y). With one random number an axis for both, the offset k = j -
//   i takes the two whole numbers next to y - x alone, with the probabilities of linear interpolation: D(x) -
//   D(y) is the mean of D_i - D_j, and k has mean y - x, within the unit square of offsets that holds y - x.
//   Give each such square a unit direction u, and let phi(k) be the least k . u (k in st units) of the
//   squares around k that don't touch 0. If D_i - D_j <= lambda phi(k) for all pairs, the mean is at most
//   lambda (y - x) . u <= lambda |x - y|. With u through the center of the square, k . u >= sqrt(|k|^2 -
//   h^2), h half a texel's diagonal: phi is that from 4 h on. In nearer squares u is midway between their
//   outermost directions, less than 90 degrees apart. Near. y - x in a square that touches 0: the chord stays
//   within a texel of the cell (cone_near.h). Relaxed. Only exits y count, so only pairs (i, j) whose y can
//   be one: k is within a texel of y - x along each axis, and j is a corner of the patch in which the ray
//   goes on from y (exitPossible). 2007: as above, exits with gradient . (y - x) > D(y). The test is coarse
//   for places a few texels apart, seen from many sides at once, which holds relaxed ratios of smooth slopes
//   close to the conservative ones; slice 0 has no such loss, and no such claim. Quad. Only pairs with an
//   offset within a texel of k in the quadrant.
//
// Wrapping. Repeat: all images count; a pair more than two tiles apart is below the cap. Clamp: outside, the
// map repeats its border, so that the point of the border nearest to y has its depth and is nearer to x (and
// grows along the same ray, if y does): texels outside don't decide, but for quadrants, where they may be in
// another one. Points outside take the ratio of the border's cell, because moving both x and y to the border
// keeps their depths and doesn't part them; as it may turn the direction, border cells of a quad map have one
// ratio in all quadrants, the least.
//
// Level k + 1 has the least ratio of each block of 2 x 2 (an odd size's last block takes three). It is right
// for a cone whose apex is at the block's least depth m <= D(x): c' (m - d) <= c (D(x) - d), so it lies
// inside the finer cone.
//
// All ratios are rounded down.
#pragma once

#include "realtime/bake/baked_map.h"
#include "realtime/bake/cone_pairs.h"

namespace plumbline {

inline constexpr int kConeTexels = 0, kConeCells = 1; // slices

/// Throws MachineError where memory doesn't suffice.
BakedMap makeConeMap(const HeightMap& map, const ConeRule& rule);

bool isConeKind(std::string_view kind);
/// The rule of a kind of cone map; throws InputError for other kinds.
ConeRule coneRule(std::string_view kind);

} // namespace plumbline
