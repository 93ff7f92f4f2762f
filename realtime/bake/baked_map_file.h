// File format of the cache (bake_cache.h): the exact values of a baked map with a checksum.
//
//   8   "PLUMBAKE"
//   4   version of this format
//   32  the key, a hash of what the map was baked from, hexadecimal
//   20  channels, slices, levels, width and height of level 0
//   8   milliseconds spent on baking, double
//   …   values of level 0, 1, …: float, in the order of BakedMap::Level
//   32  ContentHash of all of the above
// Integers are unsigned, everything is little-endian.
#pragma once

#include "realtime/bake/baked_map.h"

#include <filesystem>
#include <optional>
#include <string>

namespace plumbline {

/// Version of the format; part of the hashed key.
inline constexpr int kBakedMapFormat = 1;

struct StoredMap {
    BakedMap map; // without its kind
    double ms = 0;
};

/// `key`: 32 characters. Replaces the file atomically; throws InputError if it can't be written.
void writeBakedMap(const std::filesystem::path& file, const std::string& key, const StoredMap& stored);

/// Returns nothing if the file has another key or is damaged. Throws InputError if it is missing or not a
/// regular file, MachineError if the map doesn't fit into memory.
std::optional<StoredMap> readBakedMap(const std::filesystem::path& file, const std::string& key);

} // namespace plumbline
