// What a metric is: its figures, a row each, and how they are computed. metric_registry.h lists all there
// are; results, tables, requirements, history and the report iterate over the rows and know no figure by
// name.
//
// A metric is a pair of files. The .h has a struct of what it measures and a function that computes it over a
// selection of objects; the .cpp ends with a function that makes the Metric of them, a row a figure:
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
    PixelCount, // whole numbers
    Pixels,     // lengths in the picture
    World,
    ReliefDepth,
    Degrees,
    Texels,
    Decibels,
    LookUps,
    Rounds,
    Milliseconds,
    Bytes, // whole numbers
};

/// Which values of a figure are better.
enum class Goal {
    None,    // neither end, as of counts that a ratio is made of
    One,     // high is better, 1 is best
    Zero,    // low is better, by size: 0 is best
    Highest, // high is better, there is no best
    Lowest,  // low is better, there is no best
};

/// What there is one figure for.
enum class Scope {
    Objects,        // each object, and the pooled ones
    ObjectsByLight, // each of those and each light
    Picture,        // the whole picture
    Technique,      // the technique in this run; it doesn't come from the frames
};

/// A column of the table on the terminal; a figure with an interval gets a second one for its reach.
struct TableColumn {
    std::string head;
    int decimals = 0;
};

/// A column of the tables of the report.
struct ReportColumn {
    std::string head, note;  // the note is the head's second line: unit or what it is of
    std::string format;      // of fmt
    std::string before = {}; // key of the column in front of which it stands; empty: in the order of the rows
};

/// A row: one figure.
struct MetricInfo {
    std::string key;   // group.leaf, as in results.csv: without the light's name
    std::string label; // a few words, for the head of a column
    Unit unit = Unit::Ratio;
    Goal goal = Goal::None;
    std::string meaning;
    std::string formula = {}; // empty where the meaning says it all
    std::string source = {};  // paper; empty where there is none to cite
    std::optional<TableColumn> table = {};
    std::optional<ReportColumn> report = {};
    // The same for all figures of a metric: makeMetric fills them in.
    std::string domain = {}; // the pixels it is of
    Scope scope = Scope::Objects;
    bool hasInterval = false; // then rows <key>_low and <key>_high follow
};

/// "1" for a ratio.
std::string textOf(Unit unit);
/// Whether figures of the unit count something.
bool isWhole(Unit unit);
bool highIsBetter(Goal goal);
/// "high", "low" or "".
std::string betterText(Goal goal);
/// "1", "0" or "": the value of a perfect technique, where there is one.
std::string bestText(Goal goal);
/// What a technique spends: how good its frame is doesn't depend on it, nor it on the reference.
bool isCost(const MetricInfo& metric);

/// A block of lines: the key and what can be said in a word, then meaning, formula, domain, what it is of,
/// and source, a line each. At most 110 characters wide.
std::string describe(const MetricInfo& metric);

/// A metric over one selection of objects.
struct Measured {
    std::vector<Figure> figures; // of the metric's rows, in their order
    std::vector<uint64_t> histogram;
};

struct Metric {
    std::string group; // of results.json; with a dot a group in a group
    Scope scope = Scope::Objects;
    std::vector<MetricInfo> rows;
    std::string histogram; // its key in the group; empty: there is none
    /// Channels without which there are none of its figures, and what those are called: "normal figures".
    std::vector<const char*> channels;
    std::string figuresName;

    /// Computes what selections share and returns what computes the rest for each. Both may run on any
    /// thread; the input must outlive the result. `light`: empty unless the scope is ObjectsByLight. Of scope
    /// Technique there is no such function.
    std::function<std::function<Measured(ObjectSelection)>(const MetricInput&, const std::string& light)>
        prepare;
};

inline const char* const kSharedDomain =
    "pixels that show the same object in R and in T, with finite values in both";
inline const char* const kTestDomain = "pixels that T covers";

/// What the rows of an interval's two ends mean.
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
    // (Constructors, as g++ 12 fails on a default for `ends` in an aggregate.)
    FigureRow(MetricInfo row, std::function<Figure(const Result&)> figureOf)
        : info(std::move(row)), figure(std::move(figureOf)) {}
    FigureRow(MetricInfo row, std::function<Figure(const Result&)> figureOf, IntervalRows<Result> endRows)
        : info(std::move(row)), figure(std::move(figureOf)), ends(std::move(endRows)) {}

    MetricInfo info; // its key without the group
    std::function<Figure(const Result&)> figure;
    std::optional<IntervalRows<Result>> ends; // of a figure with an interval
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
    /// In place of `compute`, where selections share work: does that and returns what does the rest.
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

/// The row of a figure and, where it has an interval, those of its ends. `common`: what all rows of the
/// metric have in common, with the group's name and a dot as its key.
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
