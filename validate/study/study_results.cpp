#include "validate/study/study_results.h"

#include "scenes/core/error.h"
#include "validate/results/csv_text.h"
#include "validate/results/flat_figures.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>
#include <set>

namespace plumbline {

using nlohmann::json;

namespace {

std::string textAt(const json& value, const char* key) {
    const auto found = value.find(key);
    return found != value.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Rows identify techniques by label, files by name, so that a label can be changed later.
std::string labelOf(const StudyGrid& grid, const std::string& name) {
    for (const StudyTechnique& technique : grid.techniques)
        if (technique.name == name) return technique.label;
    return name;
}

double statisticOf(std::vector<double> values, const std::string& statistic) {
    std::sort(values.begin(), values.end());
    const size_t count = values.size();
    if (statistic == "count") return static_cast<double>(count);
    if (statistic == "min") return values.front();
    if (statistic == "max") return values.back();
    if (statistic == "mean")
        return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(count);
    return 0.5 * (values[(count - 1) / 2] + values[count / 2]);
}

} // namespace

void checkFigure(const std::vector<StudyRow>& rows, const StudyRows& choice) {
    std::set<std::string> names;
    for (const StudyRow& row : rows)
        if (row.grid == choice.grid)
            for (const auto& [name, value] : row.figures)
                names.insert(name);
    if (names.empty() || names.contains(choice.figure)) return;
    const std::vector<std::string> known(names.begin(), names.end());
    throw InputError("figure", fmt::format("no result has '{}'", choice.figure), "a column of results.csv",
                     didYouMean(choice.figure, known));
}

std::vector<StudyRow> rowsOf(const StudyCase& studyCase, const json& outcome) {
    StudyRow base;
    base.caseId = studyCase.id;
    base.grid = studyCase.grid->name;
    base.scene = studyCase.scene;
    base.values = studyCase.values;
    base.error = textAt(outcome, "error");
    if (!base.error.empty()) return {base};
    for (const char* part : {"reference", "fit"})
        if (outcome.contains(part)) addFlatFigures(outcome[part], part, base.figures);

    std::vector<StudyRow> rows;
    const auto add = [&](const json& entry, const char* technique, const std::string& against) {
        StudyRow row = base;
        row.technique = labelOf(*studyCase.grid, textAt(entry, technique));
        row.against = against;
        row.error = textAt(entry.at("result"), "error");
        addFlatFigures(entry.at("result"), "", row.figures);
        rows.push_back(std::move(row));
    };
    for (const json& technique : outcome.at("techniques"))
        add(technique, "name", kAgainstReference);
    for (const json& pair : outcome.at("pairs"))
        add(pair, "second", labelOf(*studyCase.grid, textAt(pair, "first")));
    return rows;
}

std::string errorOf(const StudyRow& row) {
    if (row.technique.empty()) return row.error;
    return row.technique + (row.against == kAgainstReference ? "" : " compared with " + row.against) + ": " +
           row.error;
}

std::string studyCsv(const std::vector<StudyRow>& rows) {
    std::set<std::string> axes, figures;
    for (const StudyRow& row : rows) {
        for (const auto& [name, value] : row.values)
            axes.insert(name);
        for (const auto& [name, value] : row.figures)
            figures.insert(name);
    }
    std::vector<std::string> head{"case", "grid", "scene"};
    head.insert(head.end(), axes.begin(), axes.end());
    head.insert(head.end(), {"technique", "against"});
    head.insert(head.end(), figures.begin(), figures.end());
    head.emplace_back("error");
    std::string csv = csvLine(head);
    for (const StudyRow& row : rows) {
        std::vector<std::string> cells{row.caseId, row.grid, row.scene};
        for (const std::string& axis : axes) {
            const auto found = row.values.find(axis);
            cells.push_back(found == row.values.end() ? std::string() : found->second);
        }
        cells.insert(cells.end(), {row.technique, row.against});
        for (const std::string& figure : figures) {
            const auto found = row.figures.find(figure);
            cells.push_back(found == row.figures.end() ? std::string() : fmt::format("{}", found->second));
        }
        cells.push_back(row.error);
        csv += csvLine(cells);
    }
    return csv;
}

std::string groupOf(const StudyRow& row, const std::string& grouping) {
    if (grouping == "scene") return row.scene;
    if (grouping == "technique") return row.technique;
    const auto found = row.values.find(grouping);
    return found == row.values.end() ? std::string() : found->second;
}

bool isChosen(const StudyRow& row, const StudyRows& choice) {
    if (row.grid != choice.grid || row.against != choice.against || !row.error.empty()) return false;
    return std::all_of(choice.where.begin(), choice.where.end(), [&](const auto& condition) {
        const std::vector<std::string>& allowed = condition.second;
        return std::find(allowed.begin(), allowed.end(), groupOf(row, condition.first)) != allowed.end();
    });
}

StudyCells cellsOf(const std::vector<StudyRow>& rows, const StudyRows& choice, const std::string& first,
                   const std::string& second) {
    checkFigure(rows, choice);
    std::map<std::pair<std::string, std::string>, std::vector<double>> groups;
    for (const StudyRow& row : rows) {
        if (!isChosen(row, choice)) continue;
        const auto figure = row.figures.find(choice.figure);
        if (figure != row.figures.end())
            groups[{groupOf(row, first), groupOf(row, second)}].push_back(figure->second);
    }
    StudyCells cells;
    for (auto& [key, values] : groups)
        cells.values[key] = statisticOf(std::move(values), choice.statistic);
    return cells;
}

} // namespace plumbline
