// The figures of one row of results.csv, which --require looks up by the same keys.
#pragma once

#include "validate/compare/compare.h"

namespace plumbline {

struct TechniqueOutcome;

/// Under their keys of metricTable(), in its order. `light`: whose shadow; a light the metrics lack, as "",
/// gives shadow figures that are absent. `image`: nullptr where the row is of an object: absent. `outcome`:
/// for what it cost; nullptr: absent.
MetricValues rowValues(const MetricSet& metrics, const std::string& light, const ImageError* image,
                       const TechniqueOutcome* outcome);

} // namespace plumbline
