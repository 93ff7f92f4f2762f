// Disk cache of baked maps. Each map is a file whose name is a hash of everything that its values depend on.
//
// The folder is $PLUMBLINE_CACHE, otherwise $XDG_CACHE_HOME/plumbline, otherwise $HOME/.cache/plumbline. It
// may be deleted at any time and used by several processes concurrently: files are written atomically, and
// processes that bake the same map write the same values. A damaged file is baked again. Without a folder,
// maps are baked every time.
#pragma once

#include "realtime/bake/bake.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace plumbline {

struct BakeOutcome {
    BakedMap map;
    double ms = 0;          // wall-clock time of baking it, now or when it was cached, without file access
    uint64_t bytes = 0;     // of all its values
    bool fromCache = false; // not baked in this run
    std::filesystem::path file; // in the cache; empty if it isn't cached
    std::string warning;        // why it isn't cached or was baked again; otherwise empty
};

/// The cache folder according to the environment variables, whether it exists or not; nothing if none of them
/// is set. Empty variables count as unset, as does a relative XDG_CACHE_HOME, following the XDG Base
/// Directory Specification.
std::optional<std::filesystem::path> bakeCacheFolder();

/// Hash, as 32 hexadecimal digits, of the file format, the kind and its baker's version, the map's size, wrap
/// modes and depths, and, if the kind uses them, the scale's ratios and the slices. Throws InputError like
/// bakeMap.
std::string bakeCacheKey(const HeightMap& map, const BakeRequest& request);

/// Throws what bakeMap throws; problems with the cache only set the warning.
BakeOutcome bakeCached(const HeightMap& map, const BakeRequest& request);

} // namespace plumbline
