#include "scenes/core/printable.h"
#include "validate/metrics/metric_registry.h"
#include "validate/results/number_text.h"
#include "validate/results/results.h"
#include "validate/results/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

std::string shown(const Figure& figure, int decimals) {
    return figure ? numberText(fmt::format("{{:.{}f}}", decimals), *figure) : std::string("-");
}

/// The largest possible distance of the true figure from the one shown, rounded up so that it is never
/// understated.
std::string shownReach(const Interval& interval, const Figure& figure, int decimals) {
    constexpr double kRounding = 1e-6; // in units of the last place: 0.3 - 0.2 > 0.1 by 1e-17 is no 0.11
    const Figure reach = interval.reach(figure);
    if (!reach) return "-";
    const double scale = std::pow(10.0, decimals);
    return shown(std::ceil(*reach * scale - kRounding) / scale, decimals);
}

std::vector<MetricInfo> columnsWhere(bool (*wanted)(const MetricInfo&)) {
    std::vector<MetricInfo> columns;
    for (const MetricInfo& metric : metricTable())
        if (metric.table && wanted(metric)) columns.push_back(metric);
    return columns;
}

const std::vector<MetricInfo>& qualityColumns() {
    static const std::vector<MetricInfo> columns =
        columnsWhere([](const MetricInfo& metric) { return !isCost(metric); });
    return columns;
}

const std::vector<MetricInfo>& costColumns() {
    static const std::vector<MetricInfo> columns = columnsWhere(isCost);
    return columns;
}

std::vector<std::string> headsOf(const std::vector<MetricInfo>& columns) {
    std::vector<std::string> heads;
    for (const MetricInfo& column : columns) {
        heads.push_back(column.table->head);
        if (column.hasInterval) heads.emplace_back("±");
    }
    return heads;
}

/// The light shown for all: the one with the lowest figure in the first column of lights. results.csv has
/// each.
std::string worstLight(const std::vector<MetricInfo>& columns, const MetricSet& metrics) {
    const auto column = std::ranges::find(columns, Scope::ObjectsByLight, &MetricInfo::scope);
    std::string worst;
    Figure lowest;
    for (const std::string& light : metrics.lights()) {
        if (column == columns.end()) break;
        const Figure& figure = metrics.figure(*column, light);
        if (!figure || (lowest && *figure >= *lowest)) continue;
        worst = light;
        lowest = figure;
    }
    return worst;
}

std::vector<std::string> cellsOf(const std::vector<MetricInfo>& columns, const MetricSet& metrics) {
    const std::string light = worstLight(columns, metrics);
    std::vector<std::string> cells;
    for (const MetricInfo& column : columns) {
        const Figure& figure = metrics.figure(column, light);
        cells.push_back(shown(figure, column.table->decimals));
        if (column.hasInterval)
            cells.push_back(shownReach(metrics.interval(column, light), figure, column.table->decimals));
    }
    return cells;
}

/// `first`, `cells` and `last` in one row.
std::vector<std::string> joined(const std::string& first, std::vector<std::string> cells,
                                const std::vector<std::string>& last) {
    cells.insert(cells.begin(), first);
    cells.insert(cells.end(), last.begin(), last.end());
    return cells;
}

/// "2/2", or "1/2 FAILED".
std::string reached(const std::vector<RequirementResult>& requirements) {
    const auto passed = static_cast<size_t>(std::count_if(
        requirements.begin(), requirements.end(), [](const RequirementResult& each) { return each.passed; }));
    return fmt::format("{}/{}{}", passed, requirements.size(), passed < requirements.size() ? " FAILED" : "");
}

std::string proxyTable(const Results& results) {
    TextTable table(joined("against the proxy", headsOf(qualityColumns()), {}));
    table.add(joined("(base gap)", cellsOf(qualityColumns(), results.proxy->gap.pooled), {}));
    for (const TechniqueOutcome& technique : results.techniques)
        if (technique.againstProxy)
            table.add(joined(technique.name, cellsOf(qualityColumns(), technique.againstProxy->pooled), {}));
    return table.text();
}

} // namespace

std::string toTable(const Results& results) {
    const bool required =
        std::any_of(results.techniques.begin(), results.techniques.end(),
                    [](const TechniqueOutcome& each) { return !each.requirements.empty(); });
    std::vector<std::string> costHeads = headsOf(costColumns());
    if (required) costHeads.emplace_back("require");
    TextTable table(joined("technique", headsOf(qualityColumns()), costHeads));
    std::string errors;
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error) {
            errors += fmt::format("{}: failed: {}\n", printable(technique.name), printable(*technique.error));
            continue;
        }
        const MetricSet metrics = pooledFigures(technique);
        std::vector<std::string> costCells = cellsOf(costColumns(), metrics);
        if (required) costCells.push_back(reached(technique.requirements));
        table.add(joined(technique.name, cellsOf(qualityColumns(), metrics), costCells));
    }
    std::string text = table.text() + errors;
    if (results.proxy)
        text += "\nTechniques compared with the reference on the proxy. (base gap): that reference compared "
                "with the one above, on the limit surface.\n" +
                proxyTable(results);
    return text;
}

} // namespace plumbline
