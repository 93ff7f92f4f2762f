#include "validate/metrics/metric_registry.h"
#include "validate/results/csv_text.h"
#include "validate/results/results.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

std::string cell(const MetricInfo& metric, const Figure& figure) {
    if (!figure) return {};
    return isWhole(metric.unit) ? fmt::format("{:.0f}", *figure) : fmt::format("{}", *figure);
}

/// Identifies a row, together with its object and light.
struct Subject {
    std::string technique;
    std::string reference;     // base of the reference it is compared with
    MetricSet runFigures = {}; // cost of its run
};

/// Joins figures and the other cells. Header and rows use it, so their columns stay in the same order.
std::string line(const std::string& technique, const std::string& object, const std::string& light,
                 const std::string& reference, const std::vector<std::string>& figures,
                 const std::string& error) {
    std::vector<std::string> texts{technique, object, light, reference};
    texts.insert(texts.end(), figures.begin(), figures.end());
    texts.push_back(error);
    return csvLine(texts);
}

std::string head() {
    std::vector<std::string> keys;
    for (const MetricInfo& metric : metricTable())
        keys.push_back(metric.key);
    return line("technique", "object", "light", "reference", keys, "error");
}

std::string row(const Subject& subject, const std::string& object, const std::string& light,
                const MetricSet& metrics) {
    std::vector<std::string> figures;
    for (const MetricInfo& metric : metricTable())
        figures.push_back(cell(
            metric, (metric.scope == Scope::Technique ? subject.runFigures : metrics).figure(metric, light)));
    return line(subject.technique, object, light, subject.reference, figures, "");
}

std::string failedRow(const TechniqueOutcome& technique) {
    return line(technique.name, "(pooled)", "", "", std::vector<std::string>(metricTable().size()),
                *technique.error);
}

void addRows(std::string& csv, const Subject& subject, const std::string& object, const MetricSet& metrics) {
    for (const std::string& light : metrics.lights())
        csv += row(subject, object, light, metrics);
    if (metrics.lights().empty()) csv += row(subject, object, "", metrics);
}

void addRows(std::string& csv, const Subject& subject, const Comparison& comparison) {
    addRows(csv, subject, "(pooled)", comparison.pooled);
    for (const ObjectComparison& object : comparison.objects)
        addRows(csv, subject, object.object.name, object.metrics);
}

} // namespace

std::string toCsv(const Results& results) {
    std::string csv = head();
    if (results.proxy) addRows(csv, {"(base gap)", results.base}, results.proxy->gap);
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error) {
            csv += failedRow(technique);
            continue;
        }
        Subject subject{technique.name, results.base, figuresOf(technique.cost)};
        addRows(csv, subject, technique.comparison);
        if (!technique.againstProxy) continue;
        subject.reference = "proxy";
        addRows(csv, subject, *technique.againstProxy);
    }
    return csv;
}

} // namespace plumbline
