#include "normal_angle.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace plumbline {
namespace {

constexpr std::array<const char*, 3> kChannels{"N.X", "N.Y", "N.Z"};

struct NormalPlanes {
    std::array<std::span<const float>, 3> planes;
    explicit NormalPlanes(const Frame& frame) {
        for (size_t axis = 0; axis < 3; ++axis)
            planes[axis] = frame.channel(kChannels[axis]);
    }
    Vec3 at(uint32_t pixel) const { return {planes[0][pixel], planes[1][pixel], planes[2][pixel]}; }
};

bool usable(const Vec3& normal) {
    const double length = glm::length(normal); // NaN or infinite if a component is
    return length > 0 && length < kInfinity;
}

} // namespace

NormalAngle computeNormalAngle(const FramePair& pair, ObjectSelection selection) {
    NormalAngle result;
    for (const char* channel : kChannels)
        if (const std::string missing = pair.missingChannel(channel); !missing.empty()) {
            result.meanDegrees = result.p95Degrees = Figure::absent(missing);
            return result;
        }
    const NormalPlanes reference(pair.reference()), test(pair.test());
    std::vector<double> angles;
    forSharedPixels(pair, selection, [&](uint32_t pixel, const ObjectInfo&) {
        const Vec3 a = reference.at(pixel), b = test.at(pixel);
        if (!usable(a) || !usable(b)) {
            ++result.invalidPx;
            return;
        }
        angles.push_back(degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b))));
    });
    result.domainPx = angles.size();
    if (angles.empty()) {
        result.meanDegrees = result.p95Degrees =
            Figure::absent(result.invalidPx > 0 ? "no shared pixel has a normal in both frames"
                                                : "no pixel is covered by the same object in both frames");
        return result;
    }
    result.meanDegrees =
        std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
    result.p95Degrees = nearestRank(angles, 95);
    return result;
}

MetricValues valuesOf(const NormalAngle& result) {
    return {{"domain_px", result.domainPx},
            {"mean_degrees", result.meanDegrees},
            {"p95_degrees", result.p95Degrees},
            {"invalid_px", result.invalidPx}};
}

} // namespace plumbline
