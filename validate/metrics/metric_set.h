// The figures of one selection of objects, by the keys of metricTable().
#pragma once

#include "validate/metrics/metric.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

class MetricSet {
  public:
    /// `light`: for figures that exist for every light. A figure that wasn't set is absent, with the reason.
    const Figure& figure(const MetricInfo& metric, const std::string& light = {}) const;
    /// The same by a key of metricTable().
    const Figure& figure(std::string_view key, const std::string& light = {}) const;
    /// Absent if the figure has none.
    Interval interval(const MetricInfo& metric, const std::string& light = {}) const;
    /// By its full key; empty if there is none.
    const std::vector<uint64_t>& histogram(const std::string& key) const;
    /// Lights that have figures, ascending.
    const std::set<std::string>& lights() const { return lights_; }

    void set(const MetricInfo& metric, const std::string& light, Figure figure);
    void add(const Metric& metric, const std::string& light, Measured measured);
    /// Adds the figures of another set, which must have none in common with this one.
    void add(const MetricSet& other);

  private:
    const Figure* find(const std::string& key, const std::string& light) const;

    std::map<std::pair<std::string, std::string>, Figure> figures_; // by key and light
    std::map<std::string, std::vector<uint64_t>> histograms_;
    std::set<std::string> lights_;
};

} // namespace plumbline
