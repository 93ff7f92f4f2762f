// Every key a result can hold: what `plumbline list metrics` prints, the report explains and --require takes.
#pragma once

#include <span>
#include <string>

namespace plumbline {

struct MetricInfo {
    std::string key;   // group.key, as in results.csv; shadow.* stand once for every light
    std::string label; // a few words, for the head of a column
    std::string unit;  // "1" for a ratio
    std::string best;  // the value of a perfect technique, or "" where there is none
    std::string
        better; // "high", "low" (the nearer to 0); "" where neither is, as of counts that a figure is made of
    std::string formula; // "" where the meaning says it all
    std::string domain;  // the pixels it is of
    std::string source;  // paper; "" where there is none to cite
    std::string meaning;
    bool perObject = true; // false: of the whole picture or run
};

/// In the order of results.csv.
std::span<const MetricInfo> metricTable();

/// nullptr for a key that the table lacks.
const MetricInfo* findMetric(std::string_view key);

/// Whether results hold the key's …_low and …_high.
bool hasInterval(const MetricInfo& metric);

/// A block of lines: the key and what can be said in a word, then meaning, formula, domain, what it is of,
/// and source, a line each. At most 110 characters wide.
std::string describe(const MetricInfo& metric);

} // namespace plumbline
