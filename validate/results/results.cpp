#include "validate/results/results.h"

namespace plumbline {

MetricSet pooledFigures(const TechniqueOutcome& technique) {
    MetricSet figures = technique.comparison.pooled;
    figures.add(figuresOf(technique.cost));
    return figures;
}

} // namespace plumbline
