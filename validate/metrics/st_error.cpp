#include "validate/metrics/st_error.h"

#include "scenes/core/nearest_rank.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace plumbline {
namespace {

constexpr std::array<const char*, 2> kChannels{"st.S", "st.T"};

double tileDifference(float test, float reference, bool repeats) {
    const double difference = static_cast<double>(test) - static_cast<double>(reference);
    return repeats ? difference - std::round(difference) : difference;
}

std::string noMapReason(const FramePair& pair, ObjectSelection selection) {
    for (const size_t index : selection) {
        const ObjectInfo& object = pair.objects()[index];
        if (object.map) continue;
        return object.hasRelief() ? fmt::format("the map size of '{}' is not known", object.name)
                                  : fmt::format("'{}' has no relief", object.name);
    }
    return {};
}

StError absentStError(const std::string& reason) {
    return {.meanTexels = Figure::absent(reason), .p95Texels = Figure::absent(reason)};
}

} // namespace

StError computeStError(const FramePair& pair, ObjectSelection selection) {
    if (const std::string missing = pair.missingChannel(kChannels); !missing.empty())
        return absentStError(missing);
    if (const std::string reason = noMapReason(pair, selection); !reason.empty())
        return absentStError(reason);

    const auto referenceS = pair.reference().channel("st.S"), referenceT = pair.reference().channel("st.T");
    const auto testS = pair.test().channel("st.S"), testT = pair.test().channel("st.T");
    StError result;
    std::vector<double> errors;
    errors.reserve(maxPixelCount(pair, selection));
    forSharedPixels(pair, selection, [&](uint32_t pixel, const ObjectInfo& object) {
        const double ds = tileDifference(testS[pixel], referenceS[pixel], object.map->repeatS);
        const double dt = tileDifference(testT[pixel], referenceT[pixel], object.map->repeatT);
        const double texels = std::hypot(ds * object.map->width, dt * object.map->height);
        if (std::isfinite(texels))
            errors.push_back(texels);
        else
            ++result.invalidPx;
    });
    result.domainPx = errors.size();
    if (errors.empty()) {
        result.meanTexels = result.p95Texels =
            Figure::absent(result.invalidPx > 0 ? "no shared pixel has a finite st in both frames"
                                                : "no pixel is covered by the same object in both frames");
        return result;
    }
    result.meanTexels =
        std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    result.p95Texels = nearestRankInPlace(errors, 95);
    return result;
}

Metric stErrorMetric() {
    return makeMetric<StError>({
        .group = "st",
        .domain = kSharedDomain,
        .channels = {kChannels.begin(), kChannels.end()},
        .figuresName = "st figures",
        .rows = {{{.key = "domain_px",
                   .label = "st compared",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels compared"},
                  &StError::domainPx},
                 {{.key = "mean_texels",
                   .label = "st, mean",
                   .unit = Unit::Texels,
                   .goal = Goal::Zero,
                   .meaning = "mean distance in the height map between the points shown",
                   .formula = "mean |(Δs·W, Δt·H)|, modulo one tile along an axis that repeats",
                   .report = {{"st", "mean, texels", "{:.2f}"}}},
                  &StError::meanTexels},
                 {{.key = "p95_texels",
                   .label = "st, p95",
                   .unit = Unit::Texels,
                   .goal = Goal::Zero,
                   .meaning = "95th percentile of that distance",
                   .formula = "p95, nearest rank"},
                  &StError::p95Texels},
                 {{.key = "invalid_px",
                   .label = "without st",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "shared pixels without a finite st in both: not in the domain"},
                  &StError::invalidPx}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeStError(input.pair, selection); },
    });
}

} // namespace plumbline
