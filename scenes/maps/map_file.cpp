#include "scenes/maps/map_file.h"

#include "scenes/core/error.h"
#include "scenes/core/srgb.h"
#include "scenes/image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr float kGrayNoiseInteger = 8.0f / 255.0f;
constexpr float kGrayNoiseFloat = 1e-4f;

bool hasColor(const Image& image) {
    return image.channels >= 3;
}

/// First value of a texel that `isBad`, reported with how many texels have one.
template <class IsBad>
void refuseTexels(const Image& image, const std::string& name, size_t channels, const char* what,
                  const char* expected, const IsBad& isBad) {
    size_t count = 0, firstTexel = 0;
    float firstValue = 0;
    for (size_t texel = 0; texel < image.texelCount(); ++texel) {
        const std::span<const float> values = image.texel(texel).first(channels);
        const auto bad = std::ranges::find_if(values, isBad);
        if (bad == values.end()) continue;
        if (count++ == 0) {
            firstTexel = texel;
            firstValue = *bad;
        }
    }
    if (count == 0) return;
    const auto width = static_cast<size_t>(image.width);
    throw InputError(name,
                     fmt::format("{} of {} texels are {}, the first is {} at column {}, row {} from the top",
                                 count, image.texelCount(), what, firstValue, firstTexel % width,
                                 firstTexel / width),
                     expected);
}

void checkGray(const Image& image, const std::string& name) {
    if (!hasColor(image)) return;
    const float tolerance = image.integer ? kGrayNoiseInteger : kGrayNoiseFloat;
    float widest = 0;
    for (size_t texel = 0; texel < image.texelCount(); ++texel) {
        const std::span<const float> values = image.texel(texel);
        const auto [low, high] = std::minmax({values[0], values[1], values[2]});
        widest = std::max(widest, high - low);
    }
    if (!(widest > tolerance)) return;
    throw InputError(
        name,
        fmt::format("is a color picture: red, green and blue of a texel differ by up to {:.3g}", widest),
        fmt::format("a gray one (differences up to {:.3g})", tolerance),
        "store the heights in a picture with one channel");
}

/// Rows turned over: row 0 of a picture is the top one, of a map the bottom one.
size_t flippedTexel(const Image& image, size_t texel) {
    const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
    return (height - 1 - texel / width) * width + texel % width;
}

} // namespace

HeightMap readHeightMap(const std::filesystem::path& file, Stores stores, Wrap wrapS, Wrap wrapT) {
    const Image image = readImage(file);
    const std::string name = file.string();
    refuseTexels(image, name, hasColor(image) ? 3 : 1, "NaN or outside [0,1]", "heights or depths in [0,1]",
                 [](float value) { return !(value >= 0.0f && value <= 1.0f); });
    checkGray(image, name);
    std::vector<float> depths(image.texelCount());
    for (size_t texel = 0; texel < depths.size(); ++texel) {
        const double value = image.texel(texel)[0];
        depths[flippedTexel(image, texel)] =
            static_cast<float>(stores == Stores::Depth ? value : 1.0 - value);
    }
    return HeightMap(name, image.width, image.height, std::move(depths), wrapS, wrapT);
}

ColorMap readColorMap(const std::filesystem::path& file) {
    const Image image = readImage(file);
    ColorMap map;
    map.name = file.string();
    map.width = image.width;
    map.height = image.height;
    refuseTexels(image, map.name, hasColor(image) ? 3 : 1, "negative or not finite",
                 "linear colors, 0 or more",
                 [](float value) { return !(value >= 0.0f && std::isfinite(value)); });
    map.rgb.resize(image.texelCount() * 3);
    for (size_t texel = 0; texel < image.texelCount(); ++texel)
        for (size_t channel = 0; channel < 3; ++channel) {
            const float value = image.texel(texel)[hasColor(image) ? channel : 0];
            map.rgb[3 * flippedTexel(image, texel) + channel] =
                image.integer ? static_cast<float>(linearFromSrgb(value)) : value;
        }
    return map;
}

} // namespace plumbline
