#include "results.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + "\"";
}

std::string cell(const MetricValue& entry) {
    if (const auto* count = std::get_if<uint64_t>(&entry.value)) return std::to_string(*count);
    const Figure& figure = std::get<Figure>(entry.value);
    return figure ? fmt::format("{}", *figure) : std::string();
}

/// Columns of one row: name and text. Built the same way for the head and for every row, so they can't part.
struct Row {
    std::vector<std::pair<std::string, std::string>> cells;
    void add(const std::string& name, const std::string& text) { cells.emplace_back(name, quoted(text)); }
    void add(const std::string& prefix, const MetricValues& values) {
        for (const MetricValue& entry : values)
            cells.emplace_back(prefix + "." + entry.key, cell(entry));
    }
};

Row makeRow(const TechniqueOutcome& technique, const std::string& object, const std::string& light,
            const MetricSet& metrics, const ShadowAgreement& shadow) {
    Row row;
    row.add("technique", technique.name);
    row.add("object", object);
    row.add("light", light);
    row.add("silhouette", valuesOf(metrics.silhouette));
    row.add("depth", valuesOf(metrics.depth));
    row.add("shadow", valuesOf(shadow));
    row.add("normal", valuesOf(metrics.normal));
    row.add("st", valuesOf(metrics.st));
    row.add("cost", valuesOf(metrics.cost));
    row.add("cost", {{"ms_median", technique.msMedian}});
    row.add("error", technique.error.value_or(""));
    return row;
}

std::string textOf(const Row& row, bool head) {
    std::string line;
    for (size_t i = 0; i < row.cells.size(); ++i) {
        if (i > 0) line += ",";
        line += head ? row.cells[i].first : row.cells[i].second;
    }
    return line + "\r\n";
}

void addRows(std::string& csv, const TechniqueOutcome& technique, const std::string& object,
             const MetricSet& metrics) {
    for (const auto& [light, shadow] : metrics.shadow)
        csv += textOf(makeRow(technique, object, light, metrics, shadow), false);
    if (metrics.shadow.empty()) csv += textOf(makeRow(technique, object, "", metrics, {}), false);
}

std::string failedRow(const TechniqueOutcome& technique) {
    Row row = makeRow(technique, "(pooled)", "", {}, {});
    for (auto& [name, text] : row.cells)
        if (name != "technique" && name != "object" && name != "error")
            text.clear(); // counts of nothing are no zeros
    return textOf(row, false);
}

} // namespace

std::string toCsv(const Results& results) {
    std::string csv = textOf(makeRow({}, "", "", {}, {}), true);
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error) {
            csv += failedRow(technique);
            continue;
        }
        addRows(csv, technique, "(pooled)", technique.comparison.pooled);
        for (const ObjectComparison& object : technique.comparison.objects)
            addRows(csv, technique, object.object.name, object.metrics);
    }
    return csv;
}

} // namespace plumbline
