#include "validate/metrics/normal_angle.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace plumbline {
namespace {

constexpr std::array<const char*, 3> kChannels{"N.X", "N.Y", "N.Z"};

Vec3 normalAt(const std::array<std::span<const float>, 3>& planes, uint32_t pixel) {
    return {planes[0][pixel], planes[1][pixel], planes[2][pixel]};
}

bool usable(const Vec3& normal) {
    const double length = glm::length(normal); // NaN or infinite if a component is
    return length > 0 && length < kInfinity;
}

} // namespace

PixelNormalAngle::PixelNormalAngle(const FramePair& pair) {
    for (size_t axis = 0; axis < 3; ++axis) {
        missing_ = pair.missingChannel(kChannels[axis]);
        if (!missing_.empty()) return;
        reference_[axis] = pair.reference().channel(kChannels[axis]);
        test_[axis] = pair.test().channel(kChannels[axis]);
    }
}

double PixelNormalAngle::degreesAt(uint32_t pixel) const {
    const Vec3 a = normalAt(reference_, pixel), b = normalAt(test_, pixel);
    if (!usable(a) || !usable(b)) return kNanF;
    return degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

NormalAngle computeNormalAngle(const FramePair& pair, ObjectSelection selection) {
    NormalAngle result;
    const PixelNormalAngle angle(pair);
    if (!angle.missing().empty()) {
        result.meanDegrees = result.p95Degrees = Figure::absent(angle.missing());
        return result;
    }
    std::vector<double> angles;
    angles.reserve(mostPixels(pair, selection));
    forSharedPixels(pair, selection, [&](uint32_t pixel, const ObjectInfo&) {
        const double degrees = angle.degreesAt(pixel);
        if (std::isnan(degrees))
            ++result.invalidPx;
        else
            angles.push_back(degrees);
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
    result.p95Degrees = nearestRankInPlace(angles, 95);
    return result;
}

MetricValues valuesOf(const NormalAngle& result) {
    return {{"domain_px", result.domainPx},
            {"mean_degrees", result.meanDegrees},
            {"p95_degrees", result.p95Degrees},
            {"invalid_px", result.invalidPx}};
}

} // namespace plumbline
