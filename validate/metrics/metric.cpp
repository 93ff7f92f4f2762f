#include "validate/metrics/metric.h"

#include <fmt/format.h>

namespace plumbline {

std::string textOf(Unit unit) {
    switch (unit) {
    case Unit::Ratio:
        return "1";
    case Unit::PixelCount:
    case Unit::Pixels:
        return "px";
    case Unit::World:
        return "world";
    case Unit::ReliefDepth:
        return "relief depth";
    case Unit::Degrees:
        return "degrees";
    case Unit::Texels:
        return "texels";
    case Unit::Decibels:
        return "dB";
    case Unit::Lookups:
        return "lookups";
    case Unit::Iterations:
        return "iterations";
    case Unit::Milliseconds:
        return "ms";
    case Unit::Bytes:
        break;
    }
    return "bytes";
}

bool isWhole(Unit unit) {
    return unit == Unit::PixelCount || unit == Unit::Bytes;
}

bool highIsBetter(Goal goal) {
    return goal == Goal::One || goal == Goal::Highest;
}

std::string betterText(Goal goal) {
    return goal == Goal::None ? "" : highIsBetter(goal) ? "high" : "low";
}

std::string bestText(Goal goal) {
    return goal == Goal::One ? "1" : goal == Goal::Zero ? "0" : "";
}

bool isCost(const MetricInfo& metric) {
    return metric.key.starts_with("cost.");
}

std::string describe(const MetricInfo& metric) {
    std::string text = fmt::format("{}  {}, {}", metric.key, metric.label,
                                   metric.unit == Unit::Ratio ? "a ratio" : "in " + textOf(metric.unit));
    if (const std::string better = betterText(metric.goal); !better.empty())
        text += fmt::format(", {} is better", better);
    if (const std::string best = bestText(metric.goal); !best.empty()) text += ", best " + best;
    text += "\n    " + metric.meaning + "\n";
    if (!metric.formula.empty()) text += "    formula: " + metric.formula + "\n";
    text += "    domain: " + metric.domain + "\n";
    text += metric.scope == Scope::Image || metric.scope == Scope::Technique ? "    pooled only"
                                                                             : "    per object and pooled";
    text += metric.hasInterval ? ", with an interval\n" : "\n";
    if (!metric.source.empty()) text += "    source: " + metric.source + "\n";
    return text;
}

std::vector<MetricInfo> rowsOf(MetricInfo figure, const MetricInfo& common, const EndMeanings* ends) {
    figure.key = common.key + figure.key;
    figure.domain = common.domain;
    figure.scope = common.scope;
    figure.hasInterval = ends != nullptr;
    if (!ends) return {figure};
    MetricInfo end = common;
    end.unit = figure.unit;
    end.goal = figure.goal;
    MetricInfo low = end, high = end;
    low.key = figure.key + "_low";
    low.label = figure.label + ", lowest";
    low.meaning = ends->low;
    high.key = figure.key + "_high";
    high.label = figure.label + ", highest";
    high.meaning = ends->high;
    return {figure, low, high};
}

} // namespace plumbline
