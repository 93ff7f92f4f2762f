#include "validate/metrics/depth_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

DepthError::Spread absentSpread(const std::string& reason) {
    const Figure none = Figure::absent(reason);
    return {none, none, none, none, none, none, none};
}

/// `errors`: signed, in any order, not empty.
DepthError::Spread spreadOf(const std::vector<double>& errors) {
    double sum = 0, sumAbsolute = 0, sumSquares = 0;
    std::vector<double> magnitudes;
    magnitudes.reserve(errors.size());
    for (const double error : errors) {
        sum += error;
        sumAbsolute += std::abs(error);
        sumSquares += error * error;
        magnitudes.push_back(std::abs(error));
    }
    const auto count = static_cast<double>(errors.size());
    return {.bias = sum / count,
            .mae = sumAbsolute / count,
            .rmse = std::sqrt(sumSquares / count),
            .p50 = nearestRankInPlace(magnitudes, 50),
            .p95 = nearestRankInPlace(magnitudes, 95),
            .p99 = nearestRankInPlace(magnitudes, 99),
            .max = *std::max_element(magnitudes.begin(), magnitudes.end())};
}

/// Empty if every object of the selection has a known relief depth above 0, else why one hasn't.
std::string noReliefReason(const FramePair& pair, ObjectSelection selection) {
    for (const size_t index : selection) {
        const ObjectInfo& object = pair.objects()[index];
        if (!object.reliefDepth) return fmt::format("the relief depth of '{}' is not known", object.name);
        if (!(*object.reliefDepth > 0)) return fmt::format("'{}' has no relief", object.name);
    }
    return {};
}

void countOneSided(const FramePair& pair, ObjectSelection selection, DepthError& result) {
    for (const size_t index : selection) {
        const int id = pair.objects()[index].id;
        for (const uint32_t pixel : pair.pixelsOf(index)) {
            const bool inReference = pair.referenceIds()[pixel] == id, inTest = pair.testIds()[pixel] == id;
            result.onlyReferencePx += inReference && !inTest;
            result.onlyTestPx += inTest && !inReference;
        }
    }
}

} // namespace

DepthError computeDepthError(const FramePair& pair, ObjectSelection selection,
                             std::span<const float> referenceDepth, std::span<const float> testDepth,
                             const std::string& noDepthReason) {
    DepthError result;
    countOneSided(pair, selection, result);
    const bool depthKnown = !referenceDepth.empty() && !testDepth.empty();
    const std::string noRelief = noReliefReason(pair, selection);

    std::vector<double> errors, reliefErrors;
    errors.reserve(mostPixels(pair, selection));
    if (noRelief.empty()) reliefErrors.reserve(errors.capacity());
    uint64_t uncertainPx = 0;
    forSharedPixels(pair, selection, [&](uint32_t pixel, const ObjectInfo& object) {
        if (!depthKnown || !std::isfinite(referenceDepth[pixel]) || !std::isfinite(testDepth[pixel])) {
            ++result.invalidPx;
            return;
        }
        const double error =
            static_cast<double>(testDepth[pixel]) - static_cast<double>(referenceDepth[pixel]);
        errors.push_back(error);
        uncertainPx += pair.isUncertain(pixel);
        if (!noRelief.empty()) return;
        const double depth = *object.reliefDepth;
        reliefErrors.push_back(error / depth);
        result.bad1pctPx += std::abs(error) > 0.01 * depth;
        result.bad5pctPx += std::abs(error) > 0.05 * depth;
        result.bad25pctPx += std::abs(error) > 0.25 * depth;
    });
    result.domainPx = errors.size();
    const std::string noChannel = pair.missingInReference("uncertain");
    result.uncertainPx =
        noChannel.empty() ? Figure(static_cast<double>(uncertainPx)) : Figure::absent(noChannel);

    const std::string empty = !depthKnown ? noDepthReason
                              : result.invalidPx > 0
                                  ? "no shared pixel has a finite depth in both frames"
                                  : "no pixel is covered by the same object in both frames";
    result.world = errors.empty() ? absentSpread(empty) : spreadOf(errors);
    const std::string emptyRelief = errors.empty() ? empty : noRelief;
    result.relief = reliefErrors.empty() ? absentSpread(emptyRelief) : spreadOf(reliefErrors);
    result.badpix1pct = Figure::ratio(result.bad1pctPx, reliefErrors.size(), emptyRelief);
    result.badpix5pct = Figure::ratio(result.bad5pctPx, reliefErrors.size(), emptyRelief);
    result.badpix25pct = Figure::ratio(result.bad25pctPx, reliefErrors.size(), emptyRelief);
    return result;
}

MetricValues valuesOf(const DepthError& result) {
    const DepthError::Spread &world = result.world, &relief = result.relief;
    return {{"domain_px", result.domainPx},
            {"bias", world.bias},
            {"mae", world.mae},
            {"rmse", world.rmse},
            {"p50", world.p50},
            {"p95", world.p95},
            {"p99", world.p99},
            {"max", world.max},
            {"bias_relief", relief.bias},
            {"mae_relief", relief.mae},
            {"rmse_relief", relief.rmse},
            {"p50_relief", relief.p50},
            {"p95_relief", relief.p95},
            {"p99_relief", relief.p99},
            {"max_relief", relief.max},
            {"badpix_1pct", result.badpix1pct},
            {"badpix_5pct", result.badpix5pct},
            {"badpix_25pct", result.badpix25pct},
            {"badpix_1pct_px", result.bad1pctPx},
            {"badpix_5pct_px", result.bad5pctPx},
            {"badpix_25pct_px", result.bad25pctPx},
            {"only_reference_px", result.onlyReferencePx},
            {"only_test_px", result.onlyTestPx},
            {"invalid_px", result.invalidPx},
            {"uncertain_px", wholeNumber(result.uncertainPx)}};
}

} // namespace plumbline
