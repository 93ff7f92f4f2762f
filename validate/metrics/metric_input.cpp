#include "validate/metrics/metric_input.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <set>

namespace plumbline {

PlanarDepth planarDepth(const Frame& frame, const char* which, const std::optional<Camera>& camera) {
    if (frame.has("Z")) {
        const auto plane = frame.channel("Z");
        return {{plane.begin(), plane.end()}, {}};
    }
    if (!frame.has("P.X") || !frame.has("P.Y") || !frame.has("P.Z"))
        return {{}, fmt::format("the {} frame has neither Z nor P.X P.Y P.Z", which)};
    if (!camera) return {{}, fmt::format("the {} frame has P but no Z, and the camera is not known", which)};
    const auto x = frame.channel("P.X"), y = frame.channel("P.Y"), z = frame.channel("P.Z");
    const CameraRays rays(*camera);
    PlanarDepth result;
    result.depth.resize(frame.pixelCount());
    for (size_t pixel = 0; pixel < result.depth.size(); ++pixel)
        result.depth[pixel] = static_cast<float>(rays.planarDepth(Vec3(x[pixel], y[pixel], z[pixel])));
    return result;
}

MetricInput::MetricInput(const Frame& reference, const Frame& test, std::vector<ObjectInfo> objects,
                         std::optional<Camera> viewCamera, std::vector<Light> placedLights)
    : pair(reference, test, std::move(objects)), camera(viewCamera), lights(std::move(placedLights)) {
    tbb::parallel_invoke([&] { referenceDepth = planarDepth(reference, "reference", camera); },
                         [&] { testDepth = planarDepth(test, "test", camera); });
}

std::vector<std::string> MetricInput::lightNames() const {
    std::set<std::string> names;
    for (const Frame* frame : {&pair.reference(), &pair.test()})
        for (const std::string& light : frame->lightNames())
            names.insert(light);
    return {names.begin(), names.end()};
}

std::optional<Light> MetricInput::light(const std::string& name) const {
    const auto found =
        std::find_if(lights.begin(), lights.end(), [&](const Light& light) { return light.name == name; });
    return found == lights.end() ? std::nullopt : std::optional(*found);
}

const std::string& MetricInput::noDepthReason() const {
    return referenceDepth.reason.empty() ? testDepth.reason : referenceDepth.reason;
}

} // namespace plumbline
