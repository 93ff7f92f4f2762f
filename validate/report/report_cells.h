// Cells of the report's tables as data for its template: the columns of a table and its rows are made side by
// side, so that they can't part.
#pragma once

#include "../results.h"

#include <kainjow/mustache.hpp>

#include <set>
#include <string>
#include <vector>

namespace plumbline::report {

using kainjow::mustache::data;

/// Sets only what there is to say: an empty string would still open its section of the template.
void setIfAny(data& entry, const std::string& key, const std::string& text);
data listOfTexts(const std::vector<std::string>& texts);

/// `format` of fmt for the figure; a dash with its reason where there is none.
data cell(const Figure& figure, const char* format);

std::set<std::string> lightsOf(const Results& results);

/// Heads of the metrics' columns: two for each light.
data metricHeads(const std::set<std::string>& lights);
data metricCells(const MetricSet& metrics, const std::set<std::string>& lights);
/// Heads of metricHeads and of what a technique costs.
data techniqueHeads(const std::set<std::string>& lights);
data techniqueCells(const MetricSet& metrics, const std::set<std::string>& lights,
                    const Figure& milliseconds);

} // namespace plumbline::report
