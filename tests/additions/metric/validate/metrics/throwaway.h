// Throw-away: how many pixels show an object in both frames.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct Throwaway {
    uint64_t sharedPx = 0;
};

Throwaway computeThrowaway(const FramePair& pair, ObjectSelection selection);

Metric throwawayMetric();

} // namespace plumbline
