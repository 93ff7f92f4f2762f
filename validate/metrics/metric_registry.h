// Every metric there is, in the order of results: what `plumbline list metrics` prints, results hold, the
// report shows and --require takes. Adding one: validate/README.md.
#pragma once

#include "validate/metrics/metric.h"

#include <span>
#include <string>
#include <string_view>

namespace plumbline {

std::span<const Metric> metricRegistry();

/// The rows of all metrics, in the order of results.csv.
std::span<const MetricInfo> metricTable();

/// nullptr for a key that no row has.
const MetricInfo* findMetric(std::string_view key);

/// A figure's name in results: the key of its row, and for which light.
struct FigureName {
    std::string key;   // "shadow.iou"
    std::string light; // empty: for none, or for every one
};

/// "shadow.sun.iou" to the key shadow.iou and the light sun, whether there is such a row or not; a key stays
/// one.
FigureName parseFigureName(const std::string& text);
/// The way back.
std::string textOf(const FigureName& name);

} // namespace plumbline
