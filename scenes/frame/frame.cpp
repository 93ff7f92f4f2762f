#include "scenes/frame/frame.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline {
namespace {

constexpr std::string_view kShadowPrefix = "shadow.";
constexpr std::string_view kLightPlaceholder = "<light>";

// On a miss there is no point, normal, coordinate or shadow to speak of: NaN says so, and can't be averaged
// by mistake. R G B hold the scene's background there; the renderer writes it over the 0 of this table.
constexpr std::array<ChannelInfo, 26> kChannels{{
    {"R", "", "linear", 0, "red of the shaded color; the background's on a miss"},
    {"G", "", "linear", 0, "green of the shaded color; the background's on a miss"},
    {"B", "", "linear", 0, "blue of the shaded color; the background's on a miss"},
    {"A", "", "", 0, "coverage of the pixel center, 0 or 1"},
    {"Z", "world units", "view", kInfinityF, "planar camera depth, > 0"},
    {"P.X", "world units", "world", kNanF, "position of the displaced surface, x"},
    {"P.Y", "world units", "world", kNanF, "position of the displaced surface, y"},
    {"P.Z", "world units", "world", kNanF, "position of the displaced surface, z"},
    {"N.X", "", "world", kNanF, "unit normal of the displaced surface, x"},
    {"N.Y", "", "world", kNanF, "unit normal of the displaced surface, y"},
    {"N.Z", "", "world", kNanF, "unit normal of the displaced surface, z"},
    {"st.S", "map widths", "texture", kNanF, "texture coordinate s, tiled, unwrapped"},
    {"st.T", "map heights", "texture", kNanF, "texture coordinate t, tiled, unwrapped"},
    {"id", "", "", 0, "object index + 1"},
    {"facing", "", "", kNanF, "1 where the outer side of the surface is seen, -1 where its back side is"},
    {"shadow.<light>", "", "", kNanF, "1 in shadow of the light, cast or attached (N.L <= 0); 0 lit"},
    {"cost.fetches", "look-ups", "", 0,
     "look-ups of height and baked maps, view and shadow rays (real time only)"},
    {"cost.fetches.height", "look-ups", "", 0, "those of the height map (real time only)"},
    {"cost.fetches.baked", "look-ups", "", 0,
     "those of a baked map: cone ratios, distances, normals, bounds (real time only)"},
    {"cost.iterations", "iterations", "", 0,
     "rounds of the view ray's search until it stopped (real time only)"},
    {"fault", "", "", 0,
     "what is wrong with the hits a technique's search returned here, a sum: 1 t or st isn't finite, 2 t is "
     "outside [0, 1], 4 st is off the ray (real time only)"},
    {"curvature.a", "1 / world unit", "fragment", kNanF,
     "A of the base z = -(A x^2 + C x y + B y^2) a technique was given, x along s; 0 on plain objects (real "
     "time only)"},
    {"curvature.b", "1 / world unit", "fragment", kNanF, "B of it, y along t (real time only)"},
    {"curvature.cross", "1 / world unit", "fragment", kNanF, "C of it (real time only)"},
    {"uncertain", "", "", 0, "1 where the reference's own error could change coverage (reference only)"},
    {"uncertain.shadow.<light>", "", "", 0,
     "1 where the reference's own error could change that shadow (reference only)"},
}};

/// Whether a concrete name is one of the row's: equal, or the row's prefix and a light's name.
bool matches(std::string_view rowName, std::string_view name) {
    if (!rowName.ends_with(kLightPlaceholder)) return rowName == name;
    rowName.remove_suffix(kLightPlaceholder.size());
    return name.size() > rowName.size() && name.starts_with(rowName);
}

const ChannelInfo* findRow(std::string_view channelName) {
    for (const ChannelInfo& info : kChannels)
        if (matches(info.name, channelName)) return &info;
    return nullptr;
}

std::string namesOrNone(const std::vector<std::string>& names) {
    return names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, " "));
}

} // namespace

std::span<const ChannelInfo> channelTable() {
    return kChannels;
}

const ChannelInfo& channelInfo(std::string_view channelName, std::string_view where) {
    if (const ChannelInfo* info = findRow(channelName)) return *info;
    std::vector<std::string> names;
    names.reserve(kChannels.size());
    for (const ChannelInfo& info : kChannels)
        names.emplace_back(info.name);
    throw InputError(where, fmt::format("no channel is called '{}'", channelName), listOf(names),
                     didYouMean(channelName, names));
}

bool isFrameChannel(std::string_view channelName) {
    return findRow(channelName) != nullptr;
}

std::span<float> Frame::add(std::string_view name) {
    const float missValue = channelInfo(name).missValue;
    std::vector<float>& plane = channels_[std::string(name)];
    plane.assign(pixelCount(), missValue);
    return plane;
}

bool Frame::has(std::string_view name) const {
    return channels_.find(name) != channels_.end();
}

void Frame::remove(std::string_view name) {
    if (const auto found = channels_.find(name); found != channels_.end()) channels_.erase(found);
}

std::span<const float> Frame::channel(std::string_view name) const {
    const auto found = channels_.find(name);
    if (found == channels_.end())
        throw InputError("frame", fmt::format("has no channel '{}'", name),
                         "it among the channels, which are: " + namesOrNone(channelNames()));
    return found->second;
}

std::span<float> Frame::channel(std::string_view name) {
    const std::span<const float> plane = std::as_const(*this).channel(name);
    return {const_cast<float*>(plane.data()), plane.size()}; // the plane is ours and not const here
}

std::vector<std::string> Frame::channelNames() const {
    std::vector<std::string> names;
    for (const auto& [name, plane] : channels_)
        names.push_back(name);
    return names;
}

std::vector<std::string> Frame::lightNames() const {
    std::vector<std::string> names;
    for (const auto& [name, plane] : channels_)
        if (name.starts_with(kShadowPrefix)) names.push_back(name.substr(kShadowPrefix.size()));
    return names;
}

} // namespace plumbline
