#include "validate/metrics/normal_angle.h"

#include "scenes/core/nearest_rank.h"

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
    missing_ = pair.missingChannel(kChannels);
    if (!missing_.empty()) return;
    for (size_t axis = 0; axis < 3; ++axis) {
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
    angles.reserve(maxPixelCount(pair, selection));
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

Metric normalAngleMetric() {
    return makeMetric<NormalAngle>({
        .group = "normal",
        .domain = kSharedDomain,
        .channels = {kChannels.begin(), kChannels.end()},
        .figuresName = "normal figures",
        .rows = {{{.key = "domain_px",
                   .label = "normals compared",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels compared"},
                  &NormalAngle::domainPx},
                 {{.key = "mean_degrees",
                   .label = "normal, mean",
                   .unit = Unit::Degrees,
                   .goal = Goal::Zero,
                   .meaning = "mean angle between the normals",
                   .formula = "mean atan2(|a×b|, a·b)",
                   .source = "Kahan, How Futile are Mindless Assessments of Roundoff, 2006",
                   .table = {{"normal", 2}},
                   .report = {{"normal", "mean, degrees", "{:.2f}"}}},
                  &NormalAngle::meanDegrees},
                 {{.key = "p95_degrees",
                   .label = "normal, p95",
                   .unit = Unit::Degrees,
                   .goal = Goal::Zero,
                   .meaning = "95th percentile of the angle",
                   .formula = "p95, nearest rank"},
                  &NormalAngle::p95Degrees},
                 {{.key = "invalid_px",
                   .label = "without normal",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "shared pixels without a normal in both: not in the domain"},
                  &NormalAngle::invalidPx}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeNormalAngle(input.pair, selection); },
    });
}

} // namespace plumbline
