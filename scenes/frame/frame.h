// The picture every renderer writes: one table of channels, one EXR layout.
#pragma once

#include "scenes/core/index.h"
#include "scenes/core/math.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// A row of the channel table.
struct ChannelInfo {
    std::string_view name; // "shadow.<light>" stands for one channel per light
    std::string_view unit;
    std::string_view space;
    float missValue; // where no surface covers the pixel center
    std::string_view meaning;
};

/// Every channel a frame may have, in the order of the documentation.
std::span<const ChannelInfo> channelTable();

/// Row of the table for a concrete name such as "shadow.sun"; throws InputError for a name the table lacks.
const ChannelInfo& channelInfo(std::string_view channelName, std::string_view where = "frame");

/// Whether the table has a row for it.
bool isFrameChannel(std::string_view channelName);

inline std::string shadowChannel(std::string_view lightName) {
    return "shadow." + std::string(lightName);
}
inline std::string uncertainShadowChannel(std::string_view lightName) {
    return "uncertain.shadow." + std::string(lightName);
}

/// Planes of float, row 0 = top row. A channel exists once it was added; a frame of another renderer may lack
/// some.
class Frame {
  public:
    Frame() = default;
    Frame(int width, int height) : width_(width), height_(height) {}

    int width() const { return width_; }
    int height() const { return height_; }
    size_t pixelCount() const { return areaOf(width_, height_); }

    /// Adds a channel filled with its miss value (from the table) and returns it.
    std::span<float> add(std::string_view name);
    bool has(std::string_view name) const;
    void remove(std::string_view name);
    /// The plane of a channel; throws InputError with the names there are if it is missing.
    std::span<float> channel(std::string_view name);
    std::span<const float> channel(std::string_view name) const;
    std::vector<std::string> channelNames() const;
    /// Names of the lights that have a "shadow.<light>" channel.
    std::vector<std::string> lightNames() const;

    /// Written into the file's header as strings: program version, scene hash, camera, base, technique,
    /// parameters.
    std::map<std::string, std::string> metadata;

  private:
    int width_ = 0, height_ = 0;
    std::map<std::string, std::vector<float>, std::less<>> channels_;
};

} // namespace plumbline
