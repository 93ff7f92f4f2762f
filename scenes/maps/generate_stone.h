// The generated maps that need more than a formula: `cobbles` and `noise` (generate_map.h describes them).
#pragma once

#include <vector>

namespace plumbline {

/// size x size depths, row 0 at the bottom.
std::vector<float> cobbleTexels(int size, unsigned seed);
std::vector<float> noiseTexels(int size, unsigned seed);

} // namespace plumbline
