// Cells of the report's tables, as data for its template. There is a column for each row of metricTable()
// with a ReportColumn; figures of lights have one for each light.
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

/// Does nothing for an empty text, because an empty string would also open its section of the template.
void setIfAny(data& entry, const std::string& key, const std::string& text);
data listOfTexts(const std::vector<std::string>& texts);

/// The figure in `format` of fmt; a dash with the reason if it is absent.
data cell(const Figure& figure, const std::string& format);

std::set<std::string> lightsOf(const Results& results);

struct Column {
    const MetricInfo* metric;
    std::string light; // empty unless the figure exists for every light

    /// The name of the figure in requirements, with the light.
    std::string key() const;
};

/// Columns of quality.
std::vector<Column> metricColumns(const std::set<std::string>& lights);
/// Columns of quality and of cost.
std::vector<Column> techniqueColumns(const std::set<std::string>& lights);

data headsOf(const std::vector<Column>& columns);
data cellsOf(const std::vector<Column>& columns, const MetricSet& figures);

/// The best figure of each column among techniques that aren't controls; nullopt if there are fewer than two,
/// or if the figure has no goal.
std::vector<std::optional<double>> bestOf(const std::vector<Column>& columns, const Results& results);
/// Figures of an object. Those that don't reach a requirement are marked.
data objectCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                 const ObjectComparison& object);
/// Pooled figures. The best ones and those that don't reach a requirement are marked.
data techniqueCells(const std::vector<Column>& columns, const TechniqueOutcome& technique,
                    const std::vector<std::optional<double>>& best);

} // namespace plumbline::report
