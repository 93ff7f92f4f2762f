#include "realtime/bake/baked_map_picture.h"

#include "realtime/bake/bake.h"
#include "scenes/core/free_memory.h"
#include "scenes/image/exr_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline {
namespace {

/// In front of a channel's name. Numbers are padded with zeros because viewers sort channels by name.
std::string slicePrefix(const BakeKind& kind, const BakedMap& map, int slice) {
    if (map.slices == 1) return "";
    const auto index = static_cast<size_t>(slice);
    if (index < kind.sliceNames.size()) return fmt::format("{}.", kind.sliceNames[index]);
    constexpr size_t kFewestDigits = 3;
    return fmt::format("slice{:0{}}.", slice, std::max(kFewestDigits, std::to_string(map.slices - 1).size()));
}

/// One channel of one slice, top row first.
std::vector<float> planeOf(const BakedMap& map, int slice, int channel) {
    const BakedMap::Level& level = map.levels[0];
    std::vector<float> plane;
    plane.reserve(static_cast<size_t>(level.width) * static_cast<size_t>(level.height));
    for (int row = level.height - 1; row >= 0; --row)
        for (int column = 0; column < level.width; ++column)
            plane.push_back(map.at(0, slice, column, row)[channel]);
    return plane;
}

} // namespace

void writeBakedPicture(const std::filesystem::path& file, const BakedMap& map,
                       std::map<std::string, std::string> attributes) {
    const BakedMap::Level& level = map.levels[0];
    requireMemory(file.string(), static_cast<double>(level.values.size() * sizeof(float)));
    std::map<std::string, std::vector<float>> planes;
    const BakeKind& kind = bakeKind(map.kind);
    for (int slice = 0; slice < map.slices; ++slice)
        for (int channel = 0; channel < map.channels; ++channel)
            planes[slicePrefix(kind, map, slice).append(kind.channelNames.at(static_cast<size_t>(channel)))] =
                planeOf(map, slice, channel);
    attributes["kind"] = map.kind;
    const std::map<std::string, std::span<const float>> views(planes.begin(), planes.end());
    writeExr(file, level.width, level.height, views, attributes);
}

} // namespace plumbline
