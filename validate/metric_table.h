// Every key a result can hold: what `plumbline list metrics` prints and the report explains.
#pragma once

#include <span>
#include <string_view>

namespace plumbline {

struct MetricInfo {
    std::string_view key;  // group.key, as in results.csv; shadow.* stand once for every light
    std::string_view unit; // "1" for a ratio
    std::string_view best; // the value of a perfect technique, or "" where there is none
    std::string_view meaning;
};

std::span<const MetricInfo> metricTable();

} // namespace plumbline
