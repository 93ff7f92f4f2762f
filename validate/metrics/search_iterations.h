// Iterations of a search until it stopped, which figure 4 of the secant paper shows as an image.
//
// Domain: pixels of the test frame that show an object of the selection, with a finite `cost.iterations`.
// Unit: iterations of the view ray's search as the technique counts them (bisections, secants, cone or sphere
// steps, cells).
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct SearchIterations {
    uint64_t domainPx = 0;
    Figure mean, p99, max;
    /// Pixels by iterations, from 0 to kHistogramEnd; the last bin also counts all larger values.
    std::vector<uint64_t> histogram;
    static constexpr size_t kHistogramEnd = 64;
};

/// Absent if the test frame has no channel cost.iterations.
SearchIterations computeSearchIterations(const FramePair& pair, ObjectSelection selection);

Metric searchIterationsMetric();

} // namespace plumbline
