// Cost in look-ups: what a technique spent on each pixel it covers.
//
// Domain: pixels of the test frame that show an object of the selection, with a finite `cost.fetches`. Unit:
// look-ups a pixel, of the height map and of baked maps (cone ratios, distances, normals, bounds); view and
// shadow rays together, as the harness counts them.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct FetchCost {
    uint64_t domainPx = 0;
    Figure mean, p99;
    Figure heightMean, bakedMean; // of the height map; of baked maps
};

/// Absent if the test frame has no channel cost.fetches.
FetchCost computeFetchCost(const FramePair& pair, ObjectSelection selection);

Metric fetchCostMetric();

} // namespace plumbline
