#include "validate/results/metric_table_json.h"

#include "validate/metrics/metric_table.h"

#include <nlohmann/json.hpp>

namespace plumbline {

std::string metricTableJson() {
    auto table = nlohmann::ordered_json::array();
    for (const MetricInfo& metric : metricTable())
        table.push_back({{"key", metric.key},
                         {"label", metric.label},
                         {"unit", metric.unit},
                         {"best", metric.best},
                         {"better", metric.better},
                         {"formula", metric.formula},
                         {"domain", metric.domain},
                         {"source", metric.source},
                         {"meaning", metric.meaning}});
    return table.dump();
}

} // namespace plumbline
