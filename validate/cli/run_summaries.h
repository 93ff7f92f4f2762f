// What results say of a run's scene and of its reference.
#pragma once

#include "reference/reference.h"
#include "validate/results/results.h"

#include <cstdint>

namespace plumbline {

SceneSummary summaryOf(const Scene& scene);

/// Of the reference that drew `frame`.
ReferenceSummary summaryOf(const ReferenceStats& stats, const Frame& frame);

/// Largest resident set of this process so far, bytes.
uint64_t peakBytes();

} // namespace plumbline
