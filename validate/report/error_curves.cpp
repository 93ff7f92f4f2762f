#include "validate/report/error_curves.h"

#include <algorithm>
#include <cmath>

namespace plumbline::report {
namespace {

constexpr int kHistogramBins = 50;
constexpr double kHistogramEnd = 0.25;

/// Signed errors in relief depths, ascending.
std::vector<double> sortedErrors(const FramePair& pair, const Comparison& comparison) {
    std::vector<double> errors;
    forSharedPixels(pair, pair.reliefObjects(), [&](uint32_t pixel, const ObjectInfo& object) {
        const double error = double(comparison.testDepth[pixel]) - double(comparison.referenceDepth[pixel]);
        if (std::isfinite(error)) errors.push_back(error / *object.reliefDepth);
    });
    std::sort(errors.begin(), errors.end());
    return errors;
}

uint64_t countBelow(const std::vector<double>& sorted, double limit) {
    return static_cast<uint64_t>(std::lower_bound(sorted.begin(), sorted.end(), limit) - sorted.begin());
}

uint64_t countAbove(const std::vector<double>& sorted, double limit) {
    return static_cast<uint64_t>(sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), limit));
}

} // namespace

std::vector<double> badpixThresholds() {
    std::vector<double> thresholds(kNamedThresholds.begin(), kNamedThresholds.end());
    for (int i = -32; i <= 8; ++i)
        if (i != -16) thresholds.push_back(std::pow(10.0, i / 8.0)); // 0.01 is already a named one
    std::sort(thresholds.begin(), thresholds.end());
    return thresholds;
}

std::vector<double> histogramEdges() {
    std::vector<double> edges;
    for (int i = 0; i <= kHistogramBins; ++i)
        edges.push_back(kHistogramEnd * (2 * i - kHistogramBins) / kHistogramBins);
    return edges;
}

std::optional<ErrorCurves> errorCurves(const FramePair& pair, const Comparison& comparison) {
    if (!comparison.pooled.figure("depth.rmse_relief")) return std::nullopt;
    const std::vector<double> errors = sortedErrors(pair, comparison);
    ErrorCurves curves;
    for (const double threshold : badpixThresholds())
        curves.badpix.push_back(
            static_cast<double>(countBelow(errors, -threshold) + countAbove(errors, threshold)) /
            static_cast<double>(errors.size()));
    const std::vector<double> edges = histogramEdges();
    for (size_t bin = 0; bin + 1 < edges.size(); ++bin)
        curves.counts.push_back(countBelow(errors, edges[bin + 1]) - countBelow(errors, edges[bin]));
    curves.below = countBelow(errors, edges.front());
    curves.above = errors.size() - countBelow(errors, edges.back());
    return curves;
}

} // namespace plumbline::report
