#include "validate/metrics/search_iterations.h"

#include "scenes/core/nearest_rank.h"

#include <algorithm>
#include <numeric>

namespace plumbline {

SearchIterations computeSearchIterations(const FramePair& pair, ObjectSelection selection) {
    SearchIterations result;
    const std::vector<double> iterations = valuesOnCoveredPixels(pair, selection, "cost.iterations");
    result.domainPx = iterations.size();
    if (iterations.empty()) {
        result.mean = result.p99 = result.max = Figure::absent(
            pair.test().has("cost.iterations") ? "the test frame covers no pixel with it"
                                               : "the test frame has no channel cost.iterations");
        return result;
    }
    const double largest = *std::max_element(iterations.begin(), iterations.end());
    result.mean =
        std::accumulate(iterations.begin(), iterations.end(), 0.0) / static_cast<double>(iterations.size());
    result.p99 = nearestRank(iterations, 99);
    result.max = largest;
    constexpr auto kEnd = static_cast<double>(SearchIterations::kHistogramEnd);
    result.histogram.assign(static_cast<size_t>(std::clamp(largest, 0.0, kEnd)) + 1, 0);
    for (const double count : iterations)
        ++result.histogram[static_cast<size_t>(std::clamp(count, 0.0, kEnd))];
    return result;
}

Metric searchIterationsMetric() {
    return makeMetric<SearchIterations>({
        .group = "cost",
        .domain = kTestDomain,
        .rows = {{{.key = "iterations_mean",
                   .label = "iterations, mean",
                   .unit = Unit::Iterations,
                   .goal = Goal::Lowest,
                   .meaning = "iterations of the view ray's search per covered pixel"},
                  &SearchIterations::mean},
                 {{.key = "iterations_p99",
                   .label = "iterations, p99",
                   .unit = Unit::Iterations,
                   .goal = Goal::Lowest,
                   .meaning = "99th percentile of the iterations per covered pixel, nearest rank"},
                  &SearchIterations::p99},
                 {{.key = "iterations_max",
                   .label = "iterations, max",
                   .unit = Unit::Iterations,
                   .goal = Goal::Lowest,
                   .meaning =
                       "largest number of iterations; iterations_histogram counts pixels by iterations"},
                  &SearchIterations::max}},
        .histogramKey = "iterations_histogram",
        .histogram = &SearchIterations::histogram,
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeSearchIterations(input.pair, selection); },
    });
}

} // namespace plumbline
