// The table of metrics as JSON, for the page of the report.
#pragma once

#include <string>

namespace plumbline {

/// A JSON array in the order of metricTable() with an object for each row. Its fields are texts: key, label,
/// unit, best, better, formula, domain, source, meaning. Keys are those of MetricInfo: "shadow.agreement"
/// stands for "shadow.<light>.agreement" of every light.
std::string metricTableJson();

} // namespace plumbline
