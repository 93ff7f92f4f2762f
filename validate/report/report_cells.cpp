#include "validate/report/report_cells.h"

#include "validate/metrics/metric_registry.h"
#include "validate/results/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::report {
namespace {

data cellOf(const Column& column, const MetricSet& figures) {
    const std::string& format = column.metric->report->format;
    const Figure& figure = figures.figure(*column.metric, column.light);
    data entry = cell(figure, format);
    if (!figure) return entry;
    entry.set("value", fmt::format("{}", *figure));
    if (const Interval interval = figures.interval(*column.metric, column.light); interval.low)
        entry.set("interval", fmt::format("{}–{}", numberText(format, *interval.low),
                                          numberText(format, *interval.high)));
    return entry;
}

bool isBetter(const Column& column, double a, double b) {
    return highIsBetter(column.metric->goal) ? a > b : std::abs(a) < std::abs(b); // a bias may be negative
}

/// The rows that have a column, in the order of the columns.
std::vector<const MetricInfo*> shownMetrics() {
    std::vector<const MetricInfo*> shown, inserted;
    for (const MetricInfo& metric : metricTable())
        if (metric.report) (metric.report->before.empty() ? shown : inserted).push_back(&metric);
    for (const MetricInfo* metric : inserted)
        shown.insert(std::ranges::find(shown, metric->report->before, &MetricInfo::key), metric);
    return shown;
}

/// Adjacent columns of lights are grouped by light.
std::vector<Column> columnsOf(const std::vector<const MetricInfo*>& metrics,
                              const std::set<std::string>& lights) {
    const auto isOfLights = [](const MetricInfo* metric) { return metric->scope == Scope::ObjectsByLight; };
    std::vector<Column> columns;
    for (auto metric = metrics.begin(); metric != metrics.end();) {
        if (!isOfLights(*metric)) {
            columns.push_back({*metric++, ""});
            continue;
        }
        const auto end = std::find_if_not(metric, metrics.end(), isOfLights);
        for (const std::string& light : lights)
            for (auto each = metric; each != end; ++each)
                columns.push_back({*each, light});
        metric = end;
    }
    return columns;
}

} // namespace

void setIfAny(data& entry, const std::string& key, const std::string& text) {
    if (!text.empty()) entry.set(key, text);
}

data listOfTexts(const std::vector<std::string>& texts) {
    data list{data::type::list};
    for (const std::string& text : texts)
        list << data(text);
    return list;
}

data cell(const Figure& figure, const std::string& format) {
    data entry{data::type::object};
    entry.set("text", figure ? numberText(format, *figure) : std::string("–"));
    setIfAny(entry, "reason", figure.reason());
    return entry;
}

std::set<std::string> lightsOf(const Results& results) {
    std::set<std::string> lights;
    for (const TechniqueOutcome& technique : results.techniques)
        lights.insert(technique.comparison.pooled.lights().begin(),
                      technique.comparison.pooled.lights().end());
    return lights;
}

std::string Column::key() const {
    return textOf({metric->key, light});
}

std::vector<Column> metricColumns(const std::set<std::string>& lights) {
    std::vector<const MetricInfo*> metrics = shownMetrics();
    std::erase_if(metrics, [](const MetricInfo* metric) { return isCost(*metric); });
    return columnsOf(metrics, lights);
}

std::vector<Column> techniqueColumns(const std::set<std::string>& lights) {
    return columnsOf(shownMetrics(), lights);
}

namespace {

data headOf(const Column& column) {
    const ReportColumn& shown = *column.metric->report;
    data head{data::type::object};
    head.set("key", column.key());
    head.set("text", shown.head);
    const bool both = !column.light.empty() && !shown.note.empty();
    setIfAny(head, "unit", column.light + (both ? ", " : "") + shown.note);
    setIfAny(head, "better", betterText(column.metric->goal));
    return head;
}

/// Whether the figure of that key doesn't reach a requirement.
bool isMissed(const std::string& key, const TechniqueOutcome& technique) {
    return std::any_of(technique.requirements.begin(), technique.requirements.end(),
                       [&](const RequirementResult& each) { return !each.passed && each.key == key; });
}

/// The name of an object's figure in requirements.
std::string keyOf(const Column& column, const ObjectComparison& object) {
    return column.key() + "@" + object.object.name;
}

/// A single object has no row, so its requirements are marked in the technique's row.
bool isMissedInRow(const Column& column, const TechniqueOutcome& technique) {
    const std::vector<ObjectComparison>& objects = technique.comparison.objects;
    return isMissed(column.key(), technique) ||
           (objects.size() == 1 && isMissed(keyOf(column, objects[0]), technique));
}

/// Costs have no best value, because a technique without a search is always cheapest.
bool isQuality(const Column& column) {
    return column.metric->goal != Goal::None && !isCost(*column.metric);
}

} // namespace

data headsOf(const std::vector<Column>& columns) {
    data heads{data::type::list};
    for (const Column& column : columns)
        heads << headOf(column);
    return heads;
}

data cellsOf(const std::vector<Column>& columns, const MetricSet& figures) {
    data cells{data::type::list};
    for (const Column& column : columns)
        cells << cellOf(column, figures);
    return cells;
}

std::vector<std::optional<double>> bestOf(const std::vector<Column>& columns, const Results& results) {
    std::vector<std::optional<double>> best(columns.size());
    int judged = 0;
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error || technique.control) continue;
        ++judged;
        const MetricSet& figures = technique.comparison.pooled;
        for (size_t i = 0; i < columns.size(); ++i)
            if (const Figure& figure = figures.figure(*columns[i].metric, columns[i].light);
                figure && isQuality(columns[i]) && (!best[i] || isBetter(columns[i], *figure, *best[i])))
                best[i] = *figure;
    }
    if (judged < 2) best.assign(columns.size(), std::nullopt);
    return best;
}

data objectCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                 const ObjectComparison& object) {
    data cells{data::type::list};
    for (const Column& column : columns) {
        data entry = cellOf(column, object.metrics);
        if (isMissed(keyOf(column, object), technique)) entry.set("mark", "fail");
        cells << entry;
    }
    return cells;
}

data techniqueCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                    const std::vector<std::optional<double>>& best) {
    data cells{data::type::list};
    const MetricSet figures = pooledFigures(technique);
    for (size_t i = 0; i < columns.size(); ++i) {
        const Figure& figure = figures.figure(*columns[i].metric, columns[i].light);
        data entry = cellOf(columns[i], figures);
        if (isMissedInRow(columns[i], technique))
            entry.set("mark", "fail");
        else if (!technique.control && figure && best[i] && *figure == *best[i])
            entry.set("mark", "best");
        cells << entry;
    }
    return cells;
}

} // namespace plumbline::report
