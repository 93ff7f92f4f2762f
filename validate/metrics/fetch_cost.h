// Cost in texture lookups: the number of lookups of a technique per covered pixel.
//
// Domain: pixels of the test frame that show an object of the selection, with a finite `cost.fetches`. Unit:
// lookups per pixel, in the height map and in baked maps (cone ratios, distances, normals, bounds), of view
// and shadow rays together, as the harness counts them.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct FetchCost {
    uint64_t domainPx = 0;
    Figure mean, p99;
    Figure heightMean, bakedMean; // in the height map; in baked maps
};

/// Absent if the test frame has no channel cost.fetches.
FetchCost computeFetchCost(const FramePair& pair, ObjectSelection selection);

Metric fetchCostMetric();

} // namespace plumbline
