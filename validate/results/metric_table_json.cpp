#include "validate/results/metric_table_json.h"

#include "validate/metrics/metric_registry.h"

#include <nlohmann/json.hpp>

namespace plumbline {

std::string metricTableJson() {
    auto table = nlohmann::ordered_json::array();
    for (const MetricInfo& metric : metricTable())
        table.push_back({{"key", metric.key},
                         {"label", metric.label},
                         {"unit", textOf(metric.unit)},
                         {"best", bestText(metric.goal)},
                         {"better", betterText(metric.goal)},
                         {"formula", metric.formula},
                         {"domain", metric.domain},
                         {"source", metric.source},
                         {"meaning", metric.meaning}});
    return table.dump();
}

} // namespace plumbline
