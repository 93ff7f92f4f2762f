// The table of metrics for the report's page.
#pragma once

#include <string>

namespace plumbline {

/// A JSON array in the order of metricTable(), an object a metric, all texts: key, label, unit, best, better,
/// formula, domain, source, meaning. Keys are those of MetricInfo: "shadow.agreement" stands for
/// "shadow.<light>.agreement" of every light.
std::string metricTableJson();

} // namespace plumbline
