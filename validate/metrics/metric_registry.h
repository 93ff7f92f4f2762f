// The list of all metrics, in the order of results. `plumbline list metrics`, results, the report and
// --require use it. Adding one: validate/README.md.
#pragma once

#include "validate/metrics/metric.h"

#include <span>
#include <string>
#include <string_view>

namespace plumbline {

std::span<const Metric> metricRegistry();

/// The rows of all metrics, in the order of results.csv.
std::span<const MetricInfo> metricTable();

/// nullptr for an unknown key.
const MetricInfo* findMetric(std::string_view key);

/// Name of a figure in results: the key of its row and the light.
struct FigureName {
    std::string key;   // "shadow.iou"
    std::string light; // empty: no light, or every light
};

/// Splits "shadow.sun.iou" into the key shadow.iou and the light sun, even if there is no such row. A text
/// that is the key of a row is returned as the key, without a light.
FigureName parseFigureName(const std::string& text);
/// The inverse of parseFigureName.
std::string textOf(const FigureName& name);

} // namespace plumbline
