// Cells of the report's tables as data for its template. A column is one row of metricColumns(): head,
// figures, and which end is better.
#pragma once

#include "validate/results/results.h"

#include <kainjow/mustache.hpp>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace plumbline::report {

using kainjow::mustache::data;

/// Sets nothing for an empty text, as even an empty string opens its section of the template.
void setIfAny(data& entry, const std::string& key, const std::string& text);
data listOfTexts(const std::vector<std::string>& texts);

/// The figure in `format` of fmt; a dash with the reason if it is absent.
data cell(const Figure& figure, const std::string& format);

std::set<std::string> lightsOf(const Results& results);

struct ColumnValue {
    Figure figure;
    Interval interval;
};

/// A row of a table: of a technique or of one object in it.
struct RowFigures {
    const MetricSet& metrics;
    Figure milliseconds = Figure::absent("time is measured for the whole frame");
};

struct Column {
    std::string key;        // as `plumbline list metrics` has it, with the light's name
    std::string text, unit; // of its head
    std::string better;     // "high", "low" (by size: the nearer to 0), or empty where neither end is
    std::string format;     // of fmt
    std::function<ColumnValue(const RowFigures&)> value;
};

/// What is measured: two columns for each light.
std::vector<Column> metricColumns(const std::set<std::string>& lights);
/// Those, and what a technique costs.
std::vector<Column> techniqueColumns(const std::set<std::string>& lights);

data headsOf(const std::vector<Column>& columns);
data cellsOf(const std::vector<Column>& columns, const RowFigures& row);

/// The best figure of each column among techniques that aren't controls; none if there are fewer than two, or
/// where neither end is better.
std::vector<std::optional<double>> bestOf(const std::vector<Column>& columns, const Results& results);
/// Figures of an object; those that miss a requirement are marked.
data objectCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                 const ObjectComparison& object);
/// Pooled figures; the best ones and those that miss a requirement are marked.
data techniqueCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                    const std::vector<std::optional<double>>& best);

} // namespace plumbline::report
