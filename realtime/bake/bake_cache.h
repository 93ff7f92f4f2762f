// Baked maps kept on disk, so that a map is made once: a file each, named after everything its values depend
// on.
//
// The folder is $PLUMBLINE_CACHE, else $XDG_CACHE_HOME/plumbline, else $HOME/.cache/plumbline. It may be
// deleted at any time, and used by any number of processes at once: files appear whole, and two that make the
// same map write the same values. A file that isn't to the last bit what was written is made anew. Without a
// folder maps are made each time.
#pragma once

#include "realtime/bake/bake.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace plumbline {

struct BakeOutcome {
    BakedMap map;
    double ms = 0;          // wall clock of making it, whenever that was; without reading and writing files
    uint64_t bytes = 0;     // of all its values
    bool fromCache = false; // it was not made this time
    std::filesystem::path file; // in the cache; empty if it isn't kept
    std::string warning;        // why it isn't kept, or had to be made anew; else empty
};

/// As the variables say, whether it exists or not; nothing if none of them is set. Empty ones count as not
/// set, and so does an XDG_CACHE_HOME that isn't absolute, as the XDG Base Directory Specification has it.
std::optional<std::filesystem::path> bakeCacheFolder();

/// 32 hexadecimal digits of: the format of files, kind and its builder's version, size, wrap and depths of
/// the map, and, where the kind takes them, the scale's ratios and the slices. Throws InputError like
/// bakeMap.
std::string bakeCacheKey(const HeightMap& map, const BakeRequest& request);

/// Throws what bakeMap throws; never for the cache's sake.
BakeOutcome bakeCached(const HeightMap& map, const BakeRequest& request);

} // namespace plumbline
