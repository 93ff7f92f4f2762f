// Costs of a technique in one run that aren't in channels of its frame: time and baked maps.
#pragma once

#include "validate/metrics/metric_set.h"

namespace plumbline {

struct RunCost {
    Figure bakeMs;    // time to bake its maps, in this run or when they were added to the cache
    Figure bakeBytes; // size of its baked maps in memory while drawing
    Figure msMedian;  // median time of a frame, warmed up
};

/// Figures of scope Technique.
MetricSet figuresOf(const RunCost& cost);

Metric runCostMetric();

} // namespace plumbline
