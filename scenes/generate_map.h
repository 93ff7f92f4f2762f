// Procedural height maps: the `generate = { kind, size, seed }` of a scene file. All are seamless, deterministic on every
// machine, and depths (0 = top).
#pragma once

#include "height_map.h"

namespace plumbline {

/// Kinds, in the order of the documentation.
const std::vector<std::string>& generatedMapKinds();

/// Throws InputError for an unknown kind or a size outside [1, 16384].
HeightMap generateMap(const std::string& kind, int size, unsigned seed, Wrap wrapS, Wrap wrapT);

} // namespace plumbline
