// Writes a baked map as an OpenEXR image for inspection. The cache (bake_cache.h) stores the map itself.
#pragma once

#include "realtime/bake/baked_map.h"

#include <filesystem>
#include <map>
#include <string>

namespace plumbline {

/// Writes the finest level, top row first, 32-bit float. The kind has the channels' names
/// (BakeKind::channelNames); those of several slices have the slice's name in front: texel.R and cell.R of
/// cone maps, slice000.box of a distance field.
/// The attribute `kind` is added to the given ones. The file is replaced atomically. Throws InputError if it
/// can't be written, MachineError if there isn't enough memory.
void writeBakedPicture(const std::filesystem::path& file, const BakedMap& map,
                       std::map<std::string, std::string> attributes);

} // namespace plumbline
