#include "validate/metrics/metric_registry.h"

#include "validate/metrics/boundary_iou.h"
#include "validate/metrics/contour_distance.h"
#include "validate/metrics/depth_error.h"
#include "validate/metrics/fetch_cost.h"
#include "validate/metrics/hit_faults.h"
#include "validate/metrics/image_error.h"
#include "validate/metrics/normal_angle.h"
#include "validate/metrics/run_cost.h"
#include "validate/metrics/search_iterations.h"
#include "validate/metrics/shadow_agreement.h"
#include "validate/metrics/shadow_kinds.h"
#include "validate/metrics/silhouette_iou.h"
#include "validate/metrics/st_error.h"

#include <algorithm>
#include <map>

namespace plumbline {
namespace {

/// Groups with figures for every light, each with a dot at the end.
std::vector<std::string> makeGroupsByLight() {
    std::vector<std::string> groups;
    for (const Metric& metric : metricRegistry())
        if (metric.scope == Scope::ObjectsByLight) groups.push_back(metric.group + ".");
    return groups;
}

std::vector<MetricInfo> makeTable() {
    std::vector<MetricInfo> table;
    for (const Metric& metric : metricRegistry())
        table.insert(table.end(), metric.rows.begin(), metric.rows.end());
    return table;
}

} // namespace

std::span<const Metric> metricRegistry() {
    static const std::vector<Metric> registry{
        silhouetteIouMetric(),    // silhouette
        boundaryIouMetric(),      // silhouette.boundary_iou
        contourDistanceMetric(),  // silhouette
        depthErrorMetric(),       // depth
        shadowAgreementMetric(),  // shadow.<light>
        shadowKindsMetric(),      // shadow.<light>
        normalAngleMetric(),      // normal
        stErrorMetric(),          // st
        imageErrorMetric(),       // image
        hitFaultsMetric(),        // fault
        fetchCostMetric(),        // cost
        searchIterationsMetric(), // cost
        runCostMetric(),          // cost
    };
    return registry;
}

std::span<const MetricInfo> metricTable() {
    static const std::vector<MetricInfo> table = makeTable();
    return table;
}

const MetricInfo* findMetric(std::string_view key) {
    const auto table = metricTable();
    const auto found = std::ranges::find(table, key, &MetricInfo::key);
    return found == table.end() ? nullptr : &*found;
}

FigureName parseFigureName(const std::string& text) {
    static const std::vector<std::string> groups = makeGroupsByLight();
    if (findMetric(text)) return {text, ""};
    const size_t last = text.rfind('.');
    for (const std::string& group : groups)
        if (text.starts_with(group) && last >= group.size())
            return {group + text.substr(last + 1), text.substr(group.size(), last - group.size())};
    return {text, ""};
}

std::string textOf(const FigureName& name) {
    const size_t dot = name.key.rfind('.') + 1;
    return name.light.empty() ? name.key : name.key.substr(0, dot) + name.light + name.key.substr(dot - 1);
}

} // namespace plumbline
