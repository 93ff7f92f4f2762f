// How many rounds a search took until it stopped: the secant paper's figure 4 as numbers.
//
// Domain: pixels of the test frame that show an object of the selection, with a finite `cost.iterations`.
// Unit: rounds of the view ray's search as the technique counts them (bisections, secants, cone or sphere
// steps, cells).
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct SearchIterations {
    uint64_t domainPx = 0;
    Figure mean, p99, most;
    /// Pixels by rounds, 0 first, up to kHistogramEnd; the last bin also holds everything beyond.
    std::vector<uint64_t> histogram;
    static constexpr size_t kHistogramEnd = 64;
};

/// Absent if the test frame has no channel cost.iterations.
SearchIterations computeSearchIterations(const FramePair& pair, ObjectSelection selection);

Metric searchIterationsMetric();

} // namespace plumbline
