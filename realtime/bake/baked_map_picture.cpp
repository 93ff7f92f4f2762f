#include "realtime/bake/baked_map_picture.h"

#include "scenes/core/free_memory.h"
#include "scenes/image/exr_file.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline {
namespace {

std::string sliceName(const BakedMap& map, int slice) {
    if (map.slices == 1) return "";
    if (map.kind.starts_with("cone_step") && map.slices == 2) return slice == 0 ? "texel." : "cell.";
    // Padded with zeros to the number of digits of the last slice, for a distance field to three, because
    // viewers sort channels by name.
    const size_t digits = map.kind == "distance_field" ? 3 : std::to_string(map.slices - 1).size();
    return fmt::format("slice{:0{}}.", slice, digits);
}

std::string_view channelName(const BakedMap& map, int channel) {
    constexpr std::array<std::string_view, 4> kNormal{"n.X", "n.Y", "n.Z", "D"}, kColors{"R", "G", "B", "A"};
    constexpr std::array<std::string_view, 2> kBounds{"least", "most"}, kDistances{"box", "center"};
    const auto index = static_cast<size_t>(channel);
    if (map.kind == "normal") return kNormal.at(index);
    if (map.kind == "max_mipmap") return kBounds.at(index);
    if (map.kind == "distance_field") return kDistances.at(index);
    return kColors.at(index);
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
    for (int slice = 0; slice < map.slices; ++slice)
        for (int channel = 0; channel < map.channels; ++channel)
            planes[sliceName(map, slice).append(channelName(map, channel))] = planeOf(map, slice, channel);
    attributes["kind"] = map.kind;
    const std::map<std::string, std::span<const float>> views(planes.begin(), planes.end());
    writeExr(file, level.width, level.height, views, attributes);
}

} // namespace plumbline
