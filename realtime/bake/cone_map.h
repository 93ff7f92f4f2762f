// Cone maps: for each point of a relief, the cone above it that a ray may cross in one step.
//
// Texture space: lengths in st units (map widths and heights), relief depth d, 0 on top and 1 deepest. A
// ratio c is st length per unit of depth, at most 1 (Policarpo, Oliveira, "Relaxed cone stepping for relief
// mapping", GPU Gems 3, chapter 18, 2007): the cone with its apex above x contains the points within c (D(x)
// - d) of x at depth d. The property guaranteed for the bilinear surface D is:
//   cone_step, cone_step_quad   no point of the relief is inside (quad: inside the cone's quadrant)
//   cone_step_relaxed           a descending ray that starts its step above x, outside, doesn't exit the
//                               relief inside the cone, so it enters at most once
//   cone_step_relaxed_2007      the same for rays that start above x at depth 0 only, as in chapter 18
//
// Slice 0 has for each texel center p the published ratio, computed from the other texel centers: c = min
// |q - p| / (D_p - D_q) over those higher q that count. Relaxed: a descending ray exits at q only if D
// increases outward there. For texels this means S > 0 with S = |k_s| (D(q + e_s) - D_q) + |k_t| (D(q + e_t)
// - D_q), k = q - p and e the outward unit steps. 2007: S / |k| is the relief's slope along the ray at q, and
// D_q / |k| that of the ray from depth 0 above p through q, both in depth per texel, so the ray exits there
// if and only if S > D_q. This one comparison replaces the 128 marching steps of the listing.
//
// Slice 1 has for each cell (i, j), the patch between texels (i, j) and (i + 1, j + 1), one ratio valid for
// every point of it. Let lambda = 1 / c. The condition is D(x) - D(y) <= lambda |x - y| for x in the cell and
// any y.
//
//   Far pairs. D(x) is the mean of D_i over the corners i of x's cell, where each axis chooses the upper
//   corner with the fractional position as probability; the same holds for D(y). If both use the same random
//   number per axis, the offset k = j - i only takes the two integers next to y - x, with the probabilities
//   of linear interpolation. So D(x) - D(y) is the mean of D_i - D_j, and k has mean y - x and lies in the
//   unit square of offsets that contains y - x. Give each such square a unit direction u, and let phi(k) be
//   the minimum of k . u (k in st units) over the squares around k that don't touch 0. If D_i - D_j <= lambda
//   phi(k) for all pairs, the mean is at most lambda (y - x) . u <= lambda |x - y|. With u through the center
//   of the square, k . u >= sqrt(|k|^2 - h^2), h half a texel's diagonal; phi is this bound from 4 h on. In
//   nearer squares u is the bisector of their outermost directions, which are less than 90 degrees apart.
//
//   Near pairs. If y - x is in a square that touches 0, the chord stays within one texel of the cell
//   (cone_near.h).
//
//   Relaxed. Only exits y count, so only pairs (i, j) whose y can be an exit: k is within one texel of y - x
//   along each axis, and j is a corner of the patch in which the ray continues from y (exitPossible). 2007:
//   as above, with exits where gradient . (y - x) > D(y). The test is coarse for points a few texels apart,
//   which are seen from a wide range of directions. This keeps relaxed ratios of smooth slopes close to the
//   conservative ones; slice 0 has neither this loss nor the guarantee.
//
//   Quad. Only pairs with an offset within one texel of k in the quadrant.
//
// Wrapping. Repeat: all repeated images count; the slope of a pair more than two tiles apart is below the
// cap. Clamp: outside, the map repeats its border. The border point nearest to such a y has the same depth
// and is nearer to x (and increases along the same ray if y does), so texels outside have no effect, except
// for quadrants, where they may be in another one. Points outside use the ratio of the border's cell: moving
// both x and y to the border preserves their depths and doesn't increase their distance. As it may change the
// direction, border cells of a quad map have the same ratio in all quadrants, the minimum.
//
// Level k + 1 has the minimum ratio of each block of 2 x 2 (an odd size's last block has three). It is valid
// for a cone whose apex is at the block's minimum depth m <= D(x): c' (m - d) <= c (D(x) - d), so it lies
// inside the finer cone.
//
// All ratios are rounded down.
#pragma once

#include "realtime/bake/baked_map.h"
#include "realtime/bake/cone_pairs.h"

namespace plumbline {

inline constexpr int kConeTexels = 0, kConeCells = 1; // slices

/// Throws MachineError if there isn't enough memory.
BakedMap makeConeMap(const HeightMap& map, const ConeRule& rule);

bool isConeKind(std::string_view kind);
/// The rule of a kind of cone map; throws InputError for other kinds.
ConeRule coneRule(std::string_view kind);

} // namespace plumbline
