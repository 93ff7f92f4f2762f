// Faults of the test frame: covered pixels whose values can't be, whoever drew them.
//
// A technique could hide its errors in such pixels, since the figures leave out what isn't finite. What is
// wrong with the hits that a search returned is marked by the harness, in the channel `fault`
// (scenes/frame/frame.cpp); such hits are drawn as they are, so their errors are in the figures. Unit:
// pixels.
#pragma once

#include "validate/metrics/metric.h"

#include <string>
#include <vector>

namespace plumbline {

struct HitFaults {
    uint64_t notFinitePx = 0; // a position, depth, normal, st or hit isn't finite
    Figure tOutsidePx;        // absent without the channel `fault`
    Figure offRayPx;          // likewise
};

HitFaults computeHitFaults(const FramePair& pair, ObjectSelection selection);

/// Over the whole of a frame: a sentence for each kind of fault that it has.
std::vector<std::string> faultSentences(const Frame& frame);

Metric hitFaultsMetric();

} // namespace plumbline
