#include "validate/metrics/depth_error.h"

#include "scenes/core/nearest_rank.h"

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

/// Empty if every object of the selection has a known relief depth above 0, otherwise why one doesn't.
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
    errors.reserve(maxPixelCount(pair, selection));
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

namespace {

using Rows = std::vector<FigureRow<DepthError>>;

/// A figure of a spread of errors, in relief depths. In world units it has no column.
struct SpreadRow {
    MetricInfo info;
    Figure DepthError::Spread::*figure;
};

std::vector<SpreadRow> spreadRows() {
    using Spread = DepthError::Spread;
    return {{{.key = "bias",
              .label = "depth bias",
              .goal = Goal::Zero,
              .meaning = "mean error; positive: the test's surface is too far away",
              .formula = "mean e, e = Z_T - Z_R",
              .report = {{"depth bias", "relief depth", "{:+.4f}"}}},
             &Spread::bias},
            {{.key = "mae",
              .label = "depth MAE",
              .goal = Goal::Zero,
              .meaning = "mean magnitude of the error",
              .formula = "mean |e|"},
             &Spread::mae},
            {{.key = "rmse",
              .label = "depth RMSE",
              .goal = Goal::Zero,
              .meaning = "root of the mean squared error",
              .formula = "√(mean e²)",
              .table = {{"RMSE rel", 5}},
              .report = {{"depth RMSE", "relief depth", "{:.4f}"}}},
             &Spread::rmse},
            {{.key = "p50",
              .label = "depth p50",
              .goal = Goal::Zero,
              .meaning = "median magnitude of the error",
              .formula = "p50 |e|, nearest rank"},
             &Spread::p50},
            {{.key = "p95",
              .label = "depth p95",
              .goal = Goal::Zero,
              .meaning = "95th percentile of the magnitude of the error",
              .formula = "p95 |e|, nearest rank"},
             &Spread::p95},
            {{.key = "p99",
              .label = "depth p99",
              .goal = Goal::Zero,
              .meaning = "99th percentile of the magnitude of the error",
              .formula = "p99 |e|, nearest rank",
              .table = {{"p99 rel", 5}},
              .report = {{"depth p99", "relief depth", "{:.4f}"}}},
             &Spread::p99},
            {{.key = "max",
              .label = "depth max",
              .goal = Goal::Zero,
              .meaning = "largest magnitude of the error",
              .formula = "max |e|"},
             &Spread::max}};
}

void appendSpreadRows(Rows& rows) {
    for (SpreadRow row : spreadRows()) {
        row.info.unit = Unit::World;
        row.info.table.reset();
        row.info.report.reset();
        rows.push_back(
            {row.info, [figure = row.figure](const DepthError& result) { return result.world.*figure; }});
    }
    for (SpreadRow row : spreadRows()) {
        row.info.key += "_relief";
        row.info.label += ", relief";
        row.info.unit = Unit::ReliefDepth;
        row.info.formula += "; e in relief depths of the pixel's object";
        rows.push_back(
            {row.info, [figure = row.figure](const DepthError& result) { return result.relief.*figure; }});
    }
}

void appendBadPixelRows(Rows& rows) {
    const auto ratio = [&](const std::string& percent, Figure DepthError::*figure) {
        rows.push_back(
            {{.key = "badpix_" + percent + "pct",
              .label = "bad pixels, > " + percent + " %",
              .unit = Unit::Ratio,
              .goal = Goal::Zero,
              .meaning = "share of the domain with an error above " + percent + " % of the relief depth",
              .formula = "mean [ |e| > " + percent + " % of the relief depth ], strictly",
              .source = "Scharstein, Szeliski 2002, IJCV 47"},
             figure});
    };
    ratio("1", &DepthError::badpix1pct);
    ratio("5", &DepthError::badpix5pct);
    rows.back().info.table = {"bad 5%", 4};
    rows.back().info.report = {"bad pixels", "error > 5 %", "{:.4f}"};
    ratio("25", &DepthError::badpix25pct);
    const auto count = [&](const std::string& percent, uint64_t DepthError::*pixels) {
        rows.push_back({{.key = "badpix_" + percent + "pct_px",
                         .label = "bad pixels, > " + percent + " %",
                         .unit = Unit::PixelCount,
                         .goal = Goal::Zero,
                         .meaning = "numerator of badpix_" + percent + "pct"},
                        pixels});
    };
    count("1", &DepthError::bad1pctPx);
    count("5", &DepthError::bad5pctPx);
    count("25", &DepthError::bad25pctPx);
}

void appendCountRows(Rows& rows) {
    rows.push_back({{.key = "only_reference_px",
                     .label = "only in the reference",
                     .unit = Unit::PixelCount,
                     .goal = Goal::Zero,
                     .meaning = "pixels that only the reference covers with the object: not in the domain"},
                    &DepthError::onlyReferencePx});
    rows.push_back({{.key = "only_test_px",
                     .label = "only in the test",
                     .unit = Unit::PixelCount,
                     .goal = Goal::Zero,
                     .meaning = "pixels that only the test covers with the object: not in the domain"},
                    &DepthError::onlyTestPx});
    rows.push_back({{.key = "invalid_px",
                     .label = "without depth",
                     .unit = Unit::PixelCount,
                     .goal = Goal::Zero,
                     .meaning = "shared pixels without a finite depth in both: not in the domain"},
                    &DepthError::invalidPx});
    rows.push_back(
        {{.key = "uncertain_px",
          .label = "uncertain",
          .unit = Unit::PixelCount,
          .meaning = "pixels of the domain at which the true image may show another object or none"},
         &DepthError::uncertainPx});
}

} // namespace

Metric depthErrorMetric() {
    Rows rows{{{.key = "domain_px",
                .label = "depth compared",
                .unit = Unit::PixelCount,
                .meaning = "pixels compared"},
               &DepthError::domainPx}};
    appendSpreadRows(rows);
    appendBadPixelRows(rows);
    appendCountRows(rows);
    return makeMetric<DepthError>({
        .group = "depth",
        .domain = kSharedDomain,
        .rows = std::move(rows),
        .compute =
            [](const MetricInput& input, ObjectSelection selection, const std::string&) {
                return computeDepthError(input.pair, selection, input.referenceDepth.depth,
                                         input.testDepth.depth, input.noDepthReason());
            },
    });
}

} // namespace plumbline
