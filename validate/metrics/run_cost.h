// What a technique cost in one run, beside what its frame's channels say: time and baked maps.
#pragma once

#include "validate/metrics/metric_set.h"

namespace plumbline {

struct RunCost {
    Figure bakeMs;    // of its baked maps: made, now or when they came into the cache
    Figure bakeBytes; // of its baked maps as held for drawing
    Figure msMedian;  // of one frame, warm
};

/// Of scope Technique.
MetricSet figuresOf(const RunCost& cost);

Metric runCostMetric();

} // namespace plumbline
