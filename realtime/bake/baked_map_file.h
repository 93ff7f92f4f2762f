// A baked map in a file, for the cache (bake_cache.h): exact bits, and a checksum that tells whether all of
// them are there.
//
//   8   "PLUMBAKE"
//   4   version of this format
//   32  the key: what the map was made from, hexadecimal
//   20  channels, slices, levels, width and height of level 0
//   8   milliseconds that making it took, double
//   …   values of level 0, 1, …: float, in the order of BakedMap::Level
//   32  ContentHash of all of the above
// Integers are unsigned, everything is little-endian.
#pragma once

#include "realtime/bake/baked_map.h"

#include <filesystem>
#include <optional>
#include <string>

namespace plumbline {

/// Part of what a key is made of.
inline constexpr int kBakedMapFormat = 1;

struct StoredMap {
    BakedMap map; // without its kind
    double ms = 0;
};

/// `key`: 32 letters. Write-then-rename; throws InputError if the file can't be written.
void writeBakedMap(const std::filesystem::path& file, const std::string& key, const StoredMap& stored);

/// Nothing if there is no such file, or it isn't, to the last bit, what was written under this key. Throws
/// MachineError if it doesn't fit into memory.
std::optional<StoredMap> readBakedMap(const std::filesystem::path& file, const std::string& key);

} // namespace plumbline
