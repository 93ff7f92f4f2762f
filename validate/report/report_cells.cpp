#include "validate/report/report_cells.h"

#include "validate/metrics/metric_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::report {
namespace {

data cellOf(const Column& column, const ColumnValue& value) {
    data entry = cell(value.figure, column.format);
    if (!value.figure) return entry;
    entry.set("value", fmt::format("{}", *value.figure));
    if (value.interval.low)
        entry.set("interval",
                  fmt::format("{}–{}", fmt::format(fmt::runtime(column.format), *value.interval.low),
                              fmt::format(fmt::runtime(column.format), *value.interval.high)));
    return entry;
}

Figure count(uint64_t pixels) {
    return {static_cast<double>(pixels)};
}

ShadowAgreement shadowOf(const MetricSet& metrics, const std::string& light) {
    const auto found = metrics.shadow.find(light);
    return found == metrics.shadow.end() ? ShadowAgreement{} : found->second;
}

ShadowKinds kindsOf(const MetricSet& metrics, const std::string& light) {
    const auto found = metrics.shadowKinds.find(light);
    return found == metrics.shadowKinds.end() ? ShadowKinds{} : found->second;
}

/// `light`: of a figure that there is for every light.
Column column(const std::string& metric, const std::string& light, const std::string& text,
              const std::string& unit, const char* format,
              std::function<ColumnValue(const RowFigures&)> value) {
    const MetricInfo* info = findMetric(metric);
    const std::string key = light.empty() ? metric : "shadow." + light + metric.substr(metric.rfind('.'));
    return {key, text, unit, info ? info->better : "", format, std::move(value)};
}

/// A column of a figure without an interval.
Column plain(const char* metric, const char* text, const char* unit, const char* format,
             std::function<Figure(const MetricSet&)> figure) {
    return column(metric, "", text, unit, format, [figure = std::move(figure)](const RowFigures& row) {
        return ColumnValue{figure(row.metrics), {}};
    });
}

bool isBetter(const Column& column, double a, double b) {
    return column.better == "high" ? a > b : std::abs(a) < std::abs(b); // a bias may have either sign
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
    entry.set("text", figure ? fmt::format(fmt::runtime(format), *figure) : std::string("–"));
    setIfAny(entry, "reason", figure.reason());
    return entry;
}

std::set<std::string> lightsOf(const Results& results) {
    std::set<std::string> lights;
    for (const TechniqueOutcome& technique : results.techniques)
        for (const auto& [light, shadow] : technique.comparison.pooled.shadow)
            lights.insert(light);
    return lights;
}

std::vector<Column> metricColumns(const std::set<std::string>& lights) {
    using Set = const MetricSet&;
    std::vector<Column> columns{
        column("silhouette.iou", "", "silhouette IoU", "", "{:.5f}",
               [](const RowFigures& row) {
                   return ColumnValue{row.metrics.silhouette.iou, row.metrics.silhouette.iouRange};
               }),
        plain("silhouette.missing_px", "missing", "px", "{:.0f}",
              [](Set m) { return count(m.silhouette.missingPx); }),
        plain("silhouette.extra_px", "extra", "px", "{:.0f}",
              [](Set m) { return count(m.silhouette.extraPx); }),
        column("silhouette.boundary_iou.2pct", "", "boundary IoU", "2 % of diagonal", "{:.4f}",
               [](const RowFigures& row) {
                   const BoundaryIou::AtWidth& widest = row.metrics.boundary.at.back();
                   return ColumnValue{widest.iou, widest.range};
               }),
        plain("silhouette.contour_mean_px", "outline off", "mean, px", "{:.2f}",
              [](Set m) { return m.contour.meanPx; }),
        plain("silhouette.hausdorff95_px", "outline off", "95 %, px", "{:.2f}",
              [](Set m) { return m.contour.hausdorff95Px; }),
        plain("depth.bias_relief", "depth bias", "relief depth", "{:+.4f}",
              [](Set m) { return m.depth.relief.bias; }),
        plain("depth.rmse_relief", "depth RMSE", "relief depth", "{:.4f}",
              [](Set m) { return m.depth.relief.rmse; }),
        plain("depth.p99_relief", "depth p99", "relief depth", "{:.4f}",
              [](Set m) { return m.depth.relief.p99; }),
        plain("depth.badpix_5pct", "off by > 5 %", "share", "{:.4f}",
              [](Set m) { return m.depth.badpix5pct; }),
    };
    for (const std::string& light : lights) {
        columns.push_back(column("shadow.agreement", light, "shadow agreement", light, "{:.4f}",
                                 [light](const RowFigures& row) {
                                     const ShadowAgreement shadow = shadowOf(row.metrics, light);
                                     return ColumnValue{shadow.agreement, shadow.agreementRange};
                                 }));
        columns.push_back(column("shadow.cast_agreement", light, "cast shadows", light, "{:.4f}",
                                 [light](const RowFigures& row) {
                                     return ColumnValue{kindsOf(row.metrics, light).cast.agreement, {}};
                                 }));
        columns.push_back(column("shadow.ber", light, "shadow error rate", light + ", balanced", "{:.4f}",
                                 [light](const RowFigures& row) {
                                     return ColumnValue{shadowOf(row.metrics, light).ber, {}};
                                 }));
    }
    columns.push_back(plain("normal.mean_degrees", "normal", "mean, degrees", "{:.2f}",
                            [](Set m) { return m.normal.meanDegrees; }));
    columns.push_back(
        plain("st.mean_texels", "st", "mean, texels", "{:.2f}", [](Set m) { return m.st.meanTexels; }));
    return columns;
}

std::vector<Column> techniqueColumns(const std::set<std::string>& lights) {
    std::vector<Column> columns = metricColumns(lights);
    columns.push_back(plain("cost.fetches_mean", "look-ups", "a pixel", "{:.1f}",
                            [](const MetricSet& metrics) { return metrics.cost.mean; }));
    columns.push_back(column("cost.ms_median", "", "time", "ms", "{:.1f}", [](const RowFigures& row) {
        return ColumnValue{row.milliseconds, {}};
    }));
    return columns;
}

namespace {

data headOf(const Column& column) {
    data head{data::type::object};
    head.set("key", column.key);
    head.set("text", column.text);
    setIfAny(head, "unit", column.unit);
    setIfAny(head, "better", column.better);
    return head;
}

/// Whether the figure of that key misses a requirement.
bool isMissed(const std::string& key, const TechniqueOutcome& technique) {
    return std::any_of(technique.requirements.begin(), technique.requirements.end(),
                       [&](const RequirementResult& each) { return !each.passed && each.key == key; });
}

/// As requirements name the figure of an object.
std::string keyOf(const Column& column, const ObjectComparison& object) {
    return column.key + "@" + object.object.name;
}

/// A lone object has no row of its own, so the technique's row is marked for it too.
bool isMissedInRow(const Column& column, const TechniqueOutcome& technique) {
    const std::vector<ObjectComparison>& objects = technique.comparison.objects;
    return isMissed(column.key, technique) ||
           (objects.size() == 1 && isMissed(keyOf(column, objects[0]), technique));
}

/// Costs have no best: a technique without a search is always cheapest.
bool isQuality(const Column& column) {
    return !column.better.empty() && !column.key.starts_with("cost.");
}

RowFigures rowOf(const TechniqueOutcome& technique) {
    return {technique.comparison.pooled, technique.msMedian};
}

} // namespace

data headsOf(const std::vector<Column>& columns) {
    data heads{data::type::list};
    for (const Column& column : columns)
        heads << headOf(column);
    return heads;
}

data cellsOf(const std::vector<Column>& columns, const RowFigures& row) {
    data cells{data::type::list};
    for (const Column& column : columns)
        cells << cellOf(column, column.value(row));
    return cells;
}

std::vector<std::optional<double>> bestOf(const std::vector<Column>& columns, const Results& results) {
    std::vector<std::optional<double>> best(columns.size());
    int judged = 0;
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error || technique.control) continue;
        ++judged;
        for (size_t i = 0; i < columns.size(); ++i)
            if (const Figure figure = columns[i].value(rowOf(technique)).figure;
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
        data entry = cellOf(column, column.value({object.metrics}));
        if (isMissed(keyOf(column, object), technique)) entry.set("mark", "fail");
        cells << entry;
    }
    return cells;
}

data techniqueCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                    const std::vector<std::optional<double>>& best) {
    data cells{data::type::list};
    for (size_t i = 0; i < columns.size(); ++i) {
        const ColumnValue value = columns[i].value(rowOf(technique));
        data entry = cellOf(columns[i], value);
        if (isMissedInRow(columns[i], technique))
            entry.set("mark", "fail");
        else if (!technique.control && value.figure && best[i] && *value.figure == *best[i])
            entry.set("mark", "best");
        cells << entry;
    }
    return cells;
}

} // namespace plumbline::report
