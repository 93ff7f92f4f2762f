// The interface of a metric: a row for each of its figures, and the function that computes them.
// metric_registry.h lists all metrics; results, tables, requirements, history and the report iterate over the
// rows and don't depend on particular figures.
//
// A metric is a pair of files. The .h has a struct of what is measured and a function that computes it over a
// selection of objects; the .cpp ends with a function that returns the Metric, with a row for each figure:
//
//     Metric stErrorMetric() {
//         return makeMetric<StError>({.group = "st", .domain = kSharedDomain, .rows = {…}, .compute = …});
//     }
#pragma once

#include "validate/metrics/figure.h"
#include "validate/metrics/interval.h"
#include "validate/metrics/metric_input.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

enum class Unit {
    Ratio,
    PixelCount, // integers
    Pixels,     // lengths in the image
    World,
    ReliefDepth,
    Degrees,
    Texels,
    Decibels,
    Lookups,
    Iterations,
    Milliseconds,
    Bytes, // integers
};

/// Which values of a figure are better.
enum class Goal {
    None,    // neither, as for the counts of a ratio
    One,     // high is better, 1 is best
    Zero,    // a low magnitude is better, 0 is best
    Highest, // high is better, without a best value
    Lowest,  // low is better, without a best value
};

/// What a figure is computed for.
enum class Scope {
    Objects,        // each object, and pooled
    ObjectsByLight, // the same for each light
    Image,          // the whole image
    Technique,      // the technique in this run; not computed from the frames
};

/// A column of the table on the terminal. A figure with an interval gets a second one, for Interval::reach.
struct TableColumn {
    std::string head;
    int decimals = 0;
};

/// A column of the tables of the report.
struct ReportColumn {
    std::string head, note;  // the note is the second line of the head: the unit or the statistic
    std::string format;      // of fmt
    std::string before = {}; // key of the figure whose column follows it; empty: in the order of the rows
};

/// A row: one figure.
struct MetricInfo {
    std::string key;   // group.leaf, as in results.csv, without the name of the light
    std::string label; // a few words, for the head of a column or an axis
    Unit unit = Unit::Ratio;
    Goal goal = Goal::None;
    std::string meaning;
    std::string formula = {}; // empty if the meaning is the definition
    std::string source = {};  // paper; empty if there is none to cite
    std::optional<TableColumn> table = {};
    std::optional<ReportColumn> report = {};
    // Set by makeMetric; domain and scope are the same for all figures of a metric.
    std::string domain = {}; // the pixels over which it is computed
    Scope scope = Scope::Objects;
    bool hasInterval = false; // if so, rows <key>_low and <key>_high follow
};

/// "1" for a ratio.
std::string textOf(Unit unit);
/// Whether figures of the unit are integers.
bool isWhole(Unit unit);
bool highIsBetter(Goal goal);
/// "high", "low" or "".
std::string betterText(Goal goal);
/// "1", "0" or "": the value of a perfect technique, if there is one.
std::string bestText(Goal goal);
/// Whether it is a cost of the technique. Costs don't depend on the reference.
bool isCost(const MetricInfo& metric);

/// A block of lines, at most 110 characters wide: key, label, unit and goal, then meaning, formula, domain,
/// scope and source, a line each.
std::string describe(const MetricInfo& metric);

/// A metric over one selection of objects.
struct Measured {
    std::vector<Figure> figures; // one for each row of the metric, in their order
    std::vector<uint64_t> histogram;
};

struct Metric {
    std::string group; // of results.json; a dot separates nested groups
    Scope scope = Scope::Objects;
    std::vector<MetricInfo> rows;
    std::string histogram; // its key in the group; empty: there is none
    /// Channels without which its figures are absent, and the name of these figures, e.g. "normal figures".
    std::vector<const char*> channels;
    std::string figuresName;

    /// Computes what all selections share and returns a function that computes the rest for one selection.
    /// Both may run on any thread; the input must outlive the result. `light`: empty unless the scope is
    /// ObjectsByLight. Empty for the scope Technique.
    std::function<std::function<Measured(ObjectSelection)>(const MetricInput&, const std::string& light)>
        prepare;
};

inline const char* const kSharedDomain =
    "pixels that show the same object in R and in T, with finite values in both";
inline const char* const kTestDomain = "pixels that T covers";

/// Meanings of the two rows of an interval.
struct EndMeanings {
    std::string low, high;
};

template <class Result>
struct IntervalRows {
    std::function<Interval(const Result&)> interval;
    EndMeanings meanings;
};

template <class Result>
struct FigureRow {
    // Constructors, because g++ 12 rejects a default for `ends` in an aggregate.
    FigureRow(MetricInfo row, std::function<Figure(const Result&)> figureOf)
        : info(std::move(row)), figure(std::move(figureOf)) {}
    FigureRow(MetricInfo row, std::function<Figure(const Result&)> figureOf, IntervalRows<Result> endRows)
        : info(std::move(row)), figure(std::move(figureOf)), ends(std::move(endRows)) {}

    MetricInfo info; // its key is without the group
    std::function<Figure(const Result&)> figure;
    std::optional<IntervalRows<Result>> ends; // if the figure has an interval
};

template <class Result>
struct MetricSpec {
    std::string group, domain;
    Scope scope = Scope::Objects;
    std::vector<const char*> channels = {};
    std::string figuresName = {};
    std::vector<FigureRow<Result>> rows;
    std::string histogramKey = {};
    std::function<std::vector<uint64_t>(const Result&)> histogram = {};
    std::function<Result(const MetricInput&, ObjectSelection, const std::string& light)> compute = {};
    /// Instead of `compute`, if selections share work: does that work and returns the function for the rest.
    std::function<std::function<Result(ObjectSelection)>(const MetricInput&)> prepare = {};
};

template <class Result>
Measured measure(const MetricSpec<Result>& spec, const Result& result) {
    Measured measured;
    for (const FigureRow<Result>& row : spec.rows) {
        measured.figures.push_back(row.figure(result));
        if (!row.ends) continue;
        const Interval interval = row.ends->interval(result);
        measured.figures.insert(measured.figures.end(), {interval.low, interval.high});
    }
    if (spec.histogram) measured.histogram = spec.histogram(result);
    return measured;
}

/// The row of a figure and, if it has an interval, those of its ends. `common`: what all rows of the metric
/// have in common; its key is the group and a dot.
std::vector<MetricInfo> rowsOf(MetricInfo figure, const MetricInfo& common, const EndMeanings* ends);

template <class Result>
Metric makeMetric(MetricSpec<Result> given) {
    const auto spec = std::make_shared<const MetricSpec<Result>>(std::move(given));
    Metric metric;
    metric.group = spec->group;
    metric.scope = spec->scope;
    metric.histogram = spec->histogramKey;
    metric.channels = spec->channels;
    metric.figuresName = spec->figuresName;
    MetricInfo common;
    common.key = spec->group + ".";
    common.domain = spec->domain;
    common.scope = spec->scope;
    for (const FigureRow<Result>& row : spec->rows)
        for (MetricInfo& info : rowsOf(row.info, common, row.ends ? &row.ends->meanings : nullptr))
            metric.rows.push_back(std::move(info));
    if (!spec->compute && !spec->prepare) return metric;
    metric.prepare = [spec](const MetricInput& input, const std::string& light) {
        std::function<Result(ObjectSelection)> compute;
        if (spec->prepare)
            compute = spec->prepare(input);
        else
            compute = [spec, &input, light](ObjectSelection selection) {
                return spec->compute(input, selection, light);
            };
        return [spec, compute](ObjectSelection selection) { return measure(*spec, compute(selection)); };
    };
    return metric;
}

} // namespace plumbline
