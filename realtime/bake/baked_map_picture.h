// A baked map as an OpenEXR picture, for people to look at. The cache (bake_cache.h) keeps the map itself.
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
///   any other           R G B A, as many as it has; of more slices than one, slice0.R …; cone maps call
///   their two slices texel
///                       and cell
/// The attribute `kind` is added to those given. Write-then-rename. Throws InputError if the file can't be
/// written, MachineError if memory is short.
void writeBakedPicture(const std::filesystem::path& file, const BakedMap& map,
                       std::map<std::string, std::string> attributes);

} // namespace plumbline
