// Writes a baked map as an OpenEXR image for inspection. The cache (bake_cache.h) stores the map itself.
#pragma once

#include "realtime/bake/baked_map.h"

#include <filesystem>
#include <map>
#include <string>

namespace plumbline {

/// Writes the finest level, top row first, 32-bit float. Channels by kind:
///   normal              n.X n.Y n.Z D
///   max_mipmap          least most
///   distance_field      slice000.box slice000.center slice001.box …
///   cone maps           texel.R … and cell.R …, for their two slices
///   others              R G B A, as many as there are; with several slices, slice0.R …
/// The attribute `kind` is added to the given ones. The file is replaced atomically. Throws InputError if it
/// can't be written, MachineError if there isn't enough memory.
void writeBakedPicture(const std::filesystem::path& file, const BakedMap& map,
                       std::map<std::string, std::string> attributes);

} // namespace plumbline
