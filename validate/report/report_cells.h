// Cells of the report's tables as data for its template. A column is a row of metricTable() that has one
// (ReportColumn), of figures of lights one for each light.
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

struct Column {
    const MetricInfo* metric;
    std::string light; // of a figure that there is for every light

    /// As requirements name the figure: with the light's name.
    std::string key() const;
};

/// What is measured.
std::vector<Column> metricColumns(const std::set<std::string>& lights);
/// That, and what a technique costs.
std::vector<Column> techniqueColumns(const std::set<std::string>& lights);

data headsOf(const std::vector<Column>& columns);
data cellsOf(const std::vector<Column>& columns, const MetricSet& figures);

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
