#include "validate/report/frame_data.h"

#include "validate/metrics/normal_angle.h"
#include "validate/report/layer_packing.h"
#include "validate/report/pictures.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

#include <cmath>
#include <functional>

namespace plumbline::report {
namespace {

using Json = nlohmann::json;

/// Whether all values are integers from 0 to `largest`, or NaN.
bool areCounts(std::span<const float> values, float largest) {
    for (const float value : values)
        if (!std::isnan(value) && !(value >= 0 && value <= largest && value == std::floor(value)))
            return false;
    return true;
}

template <class Whole>
std::vector<Whole> toWhole(std::span<const float> values) {
    std::vector<Whole> whole(values.size());
    for (size_t at = 0; at < values.size(); ++at)
        whole[at] = std::isnan(values[at]) ? Whole(-1) : static_cast<Whole>(values[at]);
    return whole;
}

/// Packed in the smallest type that represents every value exactly.
Json packPlane(std::span<const float> values) {
    if (areCounts(values, 254))
        return {{"type", "u8"},
                {"components", 1},
                {"has_none", true},
                {"data", packBytes(toWhole<uint8_t>(values))}};
    if (areCounts(values, 65534))
        return {{"type", "u16"},
                {"components", 1},
                {"has_none", true},
                {"data", packWords(toWhole<uint16_t>(values))}};
    return {{"type", "f32"}, {"components", 1}, {"data", packFloats(values)}};
}

Json packColor(const Frame& frame) {
    const Picture picture = colorPicture(frame);
    const size_t pixels = frame.pixelCount();
    std::vector<uint8_t> planes(3 * pixels);
    for (size_t pixel = 0; pixel < pixels; ++pixel)
        for (size_t c = 0; c < 3; ++c)
            planes[c * pixels + pixel] = picture.rgb[3 * pixel + c];
    return {{"type", "u8"}, {"components", 3}, {"data", packBytes(std::move(planes))}};
}

Json packIds(std::span<const int> ids) {
    return packPlane(std::vector<float>(ids.begin(), ids.end()));
}

/// In units of 1/256 degree.
Json packNormalAngle(const FramePair& pair) {
    constexpr double kSteps = 256;
    std::vector<uint16_t> angles(pair.referenceIds().size(), 65535);
    const PixelNormalAngle angle(pair);
    for (uint32_t pixel = 0; pixel < angles.size(); ++pixel) {
        const int id = pair.referenceIds()[pixel];
        if (id == 0 || id != pair.testIds()[pixel]) continue;
        if (const double degrees = angle.degreesAt(pixel); std::isfinite(degrees))
            angles[pixel] = static_cast<uint16_t>(std::lround(kSteps * degrees));
    }
    return {{"type", "u16"},
            {"components", 1},
            {"has_none", true},
            {"scale", 1 / kSteps},
            {"data", packWords(angles)}};
}

/// Collects layers; pack() packs them in parallel.
class Layers {
  public:
    void add(const std::string& name, std::function<Json()> pack) {
        names_.push_back(name);
        pack_.push_back(std::move(pack));
    }
    /// Adds a channel of the frame as layer `layer`, if the frame has it.
    void addChannel(const Frame& frame, const std::string& channel, const std::string& layer) {
        if (frame.has(channel)) add(layer, [&frame, channel] { return packPlane(frame.channel(channel)); });
    }
    void addCommon(const Frame& frame, std::span<const int> ids, std::span<const float> depth) {
        if (frame.has("R") && frame.has("G") && frame.has("B"))
            add("color", [&frame] { return packColor(frame); });
        add("id", [ids] { return packIds(ids); });
        if (!depth.empty()) add("depth", [depth] { return packPlane(depth); });
        for (const std::string& light : frame.lightNames())
            addChannel(frame, shadowChannel(light), shadowChannel(light));
    }
    FrameData pack() const {
        std::vector<std::string> texts(names_.size());
        tbb::parallel_for(size_t(0), names_.size(), [&](size_t i) {
            texts[i] =
                Json(names_[i]).dump(-1, ' ', true, Json::error_handler_t::replace) + ":" + pack_[i]().dump();
        });
        return {names_, fmt::format("{{{}}}", fmt::join(texts, ",\n"))};
    }

  private:
    std::vector<std::string> names_;
    std::vector<std::function<Json()>> pack_;
};

} // namespace

FrameData packReference(const FramePair& pair, std::span<const float> depth) {
    const Frame& frame = pair.reference();
    Layers layers;
    layers.addCommon(frame, pair.referenceIds(), depth);
    layers.addChannel(frame, "uncertain", "uncertain");
    for (const std::string& light : frame.lightNames())
        layers.addChannel(frame, uncertainShadowChannel(light), uncertainShadowChannel(light));
    return layers.pack();
}

FrameData packTest(const FramePair& pair, std::span<const float> depth) {
    const Frame& frame = pair.test();
    Layers layers;
    layers.addCommon(frame, pair.testIds(), depth);
    if (PixelNormalAngle(pair).missing().empty())
        layers.add("normal_angle", [&pair] { return packNormalAngle(pair); });
    layers.addChannel(frame, "cost.fetches", "fetches");
    layers.addChannel(frame, "cost.iterations", "iterations");
    return layers.pack();
}

FrameData packCounts(const std::string& layer, const std::vector<uint16_t>& counts) {
    const std::vector<float> values(counts.begin(), counts.end());
    Layers layers;
    layers.add(layer, [&values] { return packPlane(values); });
    return layers.pack();
}

std::string frameScript(const std::string& file, const FrameData& frame) {
    return fmt::format("{}{},{});\n", kFrameScriptBeginning, Json(file).dump(-1, ' ', true), frame.json);
}

} // namespace plumbline::report
