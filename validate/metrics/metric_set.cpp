#include "validate/metrics/metric_set.h"

#include "validate/metrics/metric_registry.h"

#include <cassert>

namespace plumbline {
namespace {

/// Why a set lacks a figure.
const Figure& missing(const MetricInfo& metric) {
    static const Figure ofImage = Figure::absent("it is computed for the whole image only"),
                        ofRun = Figure::absent("it is measured for the whole frame only"), ofObjects;
    return metric.scope == Scope::Image ? ofImage : metric.scope == Scope::Technique ? ofRun : ofObjects;
}

} // namespace

const Figure* MetricSet::find(const std::string& key, const std::string& light) const {
    const auto found = figures_.find({key, light});
    return found == figures_.end() ? nullptr : &found->second;
}

const Figure& MetricSet::figure(const MetricInfo& metric, const std::string& light) const {
    const Figure* found = find(metric.key, metric.scope == Scope::ObjectsByLight ? light : std::string());
    return found ? *found : missing(metric);
}

const Figure& MetricSet::figure(std::string_view key, const std::string& light) const {
    const MetricInfo* metric = findMetric(key);
    assert(metric);
    return figure(*metric, light);
}

Interval MetricSet::interval(const MetricInfo& metric, const std::string& light) const {
    if (!metric.hasInterval) return {};
    return {figure(metric.key + "_low", light), figure(metric.key + "_high", light)};
}

const std::vector<uint64_t>& MetricSet::histogram(const std::string& key) const {
    static const std::vector<uint64_t> none;
    const auto found = histograms_.find(key);
    return found == histograms_.end() ? none : found->second;
}

void MetricSet::set(const MetricInfo& metric, const std::string& light, Figure figure) {
    assert(light.empty() || metric.scope == Scope::ObjectsByLight);
    figures_.insert_or_assign({metric.key, light}, std::move(figure));
    if (metric.scope == Scope::ObjectsByLight) lights_.insert(light);
}

void MetricSet::add(const Metric& metric, const std::string& light, Measured measured) {
    assert(measured.figures.size() == metric.rows.size());
    for (size_t row = 0; row < metric.rows.size(); ++row)
        set(metric.rows[row], light, std::move(measured.figures[row]));
    if (!measured.histogram.empty())
        histograms_[metric.group + "." + metric.histogram] = std::move(measured.histogram);
}

void MetricSet::add(const MetricSet& other) {
    figures_.insert(other.figures_.begin(), other.figures_.end());
    histograms_.insert(other.histograms_.begin(), other.histograms_.end());
    lights_.insert(other.lights_.begin(), other.lights_.end());
}

} // namespace plumbline
