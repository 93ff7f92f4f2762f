#include "validate/results/csv_text.h"
#include "validate/results/results.h"
#include "validate/results/row_values.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

std::string cell(const MetricValue& entry) {
    if (const auto* count = std::get_if<uint64_t>(&entry.value)) return std::to_string(*count);
    const Figure& figure = std::get<Figure>(entry.value);
    return figure ? fmt::format("{}", *figure) : std::string();
}

/// Columns of one row: name and text. Built the same way for the head and for every row, so they can't part.
struct Row {
    std::vector<std::pair<std::string, std::string>> cells;
    void add(const std::string& name, const std::string& text) { cells.emplace_back(name, text); }
};

/// What a row is of, beyond its object and light.
struct Subject {
    std::string technique;
    std::string reference; // base of the reference held against
    std::string error = {};
    const TechniqueOutcome* outcome = nullptr; // for what it cost; nullptr: nothing is known of that
};

/// `image`: of the pooled row; nullptr: empty cells.
Row makeRow(const Subject& subject, const std::string& object, const std::string& light,
            const MetricSet& metrics, const ImageError* image) {
    Row row;
    row.add("technique", subject.technique);
    row.add("object", object);
    row.add("light", light);
    row.add("reference", subject.reference);
    for (const MetricValue& entry : rowValues(metrics, light, image, subject.outcome))
        row.add(entry.key, cell(entry));
    row.add("error", subject.error);
    return row;
}

std::string textOf(const Row& row, bool head) {
    std::vector<std::string> texts;
    for (const auto& [name, text] : row.cells)
        texts.push_back(head ? name : text);
    return csvLine(texts);
}

void addRows(std::string& csv, const Subject& subject, const std::string& object, const MetricSet& metrics,
             const ImageError* image) {
    for (const auto& [light, shadow] : metrics.shadow)
        csv += textOf(makeRow(subject, object, light, metrics, image), false);
    if (metrics.shadow.empty()) csv += textOf(makeRow(subject, object, "", metrics, image), false);
}

void addRows(std::string& csv, const Subject& subject, const Comparison& comparison) {
    addRows(csv, subject, "(pooled)", comparison.pooled, &comparison.image);
    for (const ObjectComparison& object : comparison.objects)
        addRows(csv, subject, object.object.name, object.metrics, nullptr);
}

std::string failedRow(const Subject& subject) {
    Row row = makeRow(subject, "(pooled)", "", {}, nullptr);
    for (auto& [name, text] : row.cells)
        if (name != "technique" && name != "object" && name != "error")
            text.clear(); // counts of nothing are no zeros
    return textOf(row, false);
}

} // namespace

std::string toCsv(const Results& results) {
    std::string csv = textOf(makeRow({}, "", "", {}, nullptr), true);
    if (results.proxy) addRows(csv, {"(base gap)", results.base}, results.proxy->gap);
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error) {
            csv += failedRow({technique.name, "", *technique.error});
            continue;
        }
        Subject subject{technique.name, results.base, "", &technique};
        addRows(csv, subject, technique.comparison);
        if (!technique.againstProxy) continue;
        subject.reference = "proxy";
        addRows(csv, subject, *technique.againstProxy);
    }
    return csv;
}

} // namespace plumbline
