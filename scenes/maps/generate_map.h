// Procedural height maps: the `generate = { kind, size, seed }` of a scene file. All are seamless depth maps
// (0 = top) and bit-identical on every machine: they use only IEEE arithmetic and square roots, no library
// sine and no library random numbers.
//
// A map has the same content at every size, except `pins` and `fins`, whose widths are counted in texels:
//   cobbles   6 x 6 rounded stones of different height, deep joints         (cellular texture, Worley 1996)
//   bricks    running bond of 4 x 8 beveled bricks of different height; mortar flat at depth 1
//   pyramids  8 x 8 adjacent square pyramids, apex up: 2 max(|x - 1/2|, |y - 1/2|), x and y across a cell
//   pins      square columns 1 to 4 texels wide, one in about 16 x 16 texels: depth 0 on a floor of depth 1
//   fins      walls along t, 1 to 4 texels thick, one in about 16 texels: depth 0 on a floor of depth 1
//   waves     1/2 - (0.25 sin(a) + 0.15 sin(b) + 0.1 sin(c)), a, b, c = 2 pi times 2s + t, -s + 3t, 4s - 3t,
//             plus phases derived from the seed, which are 0 for seed 0
//   ramp      1 - |2s - 1|: linear down from s = 0 to 1/2 and up again, so that it tiles
//   noise     gradient noise (Perlin 1985) of 4 to 128 cells a tile, each octave with half the amplitude
// The seed affects cobbles, bricks, pins, fins, waves and noise; pyramids and ramp are deterministic.
#pragma once

#include "scenes/maps/height_map.h"

namespace plumbline {

inline constexpr int kMaxGeneratedTexels = 16384; // along one side

/// Kinds, in the order of the documentation.
const std::vector<std::string>& generatedMapKinds();

/// size x size texels. Throws InputError for an unknown kind or a size outside [1, kMaxGeneratedTexels].
HeightMap generateMap(const std::string& kind, int size, unsigned seed, Wrap wrapS, Wrap wrapT);

} // namespace plumbline
