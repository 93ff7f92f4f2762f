#include "report_cells.h"

#include <fmt/format.h>

namespace plumbline::report {
namespace {

/// A figure with its interval below it.
data cell(const Figure& figure, const Interval& interval, const char* format) {
    data entry = report::cell(figure, format);
    if (interval.low)
        entry.set("interval", fmt::format("{}–{}", fmt::format(fmt::runtime(format), *interval.low),
                                          fmt::format(fmt::runtime(format), *interval.high)));
    return entry;
}

data cell(uint64_t count) {
    data entry{data::type::object};
    entry.set("text", std::to_string(count));
    return entry;
}

void addHead(data& heads, const std::string& text, const std::string& unit) {
    data head{data::type::object};
    head.set("text", text);
    setIfAny(head, "unit", unit);
    heads << head;
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

data cell(const Figure& figure, const char* format) {
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

data metricHeads(const std::set<std::string>& lights) {
    data heads{data::type::list};
    addHead(heads, "silhouette IoU", "");
    addHead(heads, "missing", "px");
    addHead(heads, "extra", "px");
    addHead(heads, "outline off", "mean, px");
    addHead(heads, "outline off", "95 %, px");
    addHead(heads, "depth bias", "relief depth");
    addHead(heads, "depth RMSE", "relief depth");
    addHead(heads, "depth p99", "relief depth");
    addHead(heads, "off by > 5 %", "share");
    for (const std::string& light : lights) {
        addHead(heads, "shadow agreement", light);
        addHead(heads, "shadow error rate", light + ", balanced");
    }
    addHead(heads, "normal", "mean, degrees");
    addHead(heads, "st", "mean, texels");
    return heads;
}

data metricCells(const MetricSet& metrics, const std::set<std::string>& lights) {
    data cells{data::type::list};
    cells << cell(metrics.silhouette.iou, metrics.silhouette.iouRange, "{:.5f}")
          << cell(metrics.silhouette.missingPx) << cell(metrics.silhouette.extraPx)
          << cell(metrics.contour.meanPx, "{:.2f}") << cell(metrics.contour.hausdorff95Px, "{:.2f}")
          << cell(metrics.depth.relief.bias, "{:+.4f}") << cell(metrics.depth.relief.rmse, "{:.4f}")
          << cell(metrics.depth.relief.p99, "{:.4f}") << cell(metrics.depth.badpix5pct, "{:.4f}");
    for (const std::string& light : lights) {
        const auto found = metrics.shadow.find(light);
        const ShadowAgreement shadow = found == metrics.shadow.end() ? ShadowAgreement{} : found->second;
        cells << cell(shadow.agreement, shadow.agreementRange, "{:.4f}") << cell(shadow.ber, "{:.4f}");
    }
    cells << cell(metrics.normal.meanDegrees, "{:.2f}") << cell(metrics.st.meanTexels, "{:.2f}");
    return cells;
}

data techniqueHeads(const std::set<std::string>& lights) {
    data heads = metricHeads(lights);
    addHead(heads, "look-ups", "a pixel");
    addHead(heads, "time", "ms");
    return heads;
}

data techniqueCells(const MetricSet& metrics, const std::set<std::string>& lights,
                    const Figure& milliseconds) {
    data cells = metricCells(metrics, lights);
    cells << cell(metrics.cost.mean, "{:.1f}") << cell(milliseconds, "{:.1f}");
    return cells;
}

} // namespace plumbline::report
