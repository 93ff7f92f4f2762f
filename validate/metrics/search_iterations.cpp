#include "validate/metrics/search_iterations.h"

#include "scenes/core/nearest_rank.h"

#include <algorithm>
#include <numeric>

namespace plumbline {

SearchIterations computeSearchIterations(const FramePair& pair, ObjectSelection selection) {
    SearchIterations result;
    const std::vector<double> rounds = valuesOnCoveredPixels(pair, selection, "cost.iterations");
    result.domainPx = rounds.size();
    if (rounds.empty()) {
        result.mean = result.p99 = result.most = Figure::absent(
            pair.test().has("cost.iterations") ? "the test frame covers no pixel with it"
                                               : "the test frame has no channel cost.iterations");
        return result;
    }
    const double most = *std::max_element(rounds.begin(), rounds.end());
    result.mean = std::accumulate(rounds.begin(), rounds.end(), 0.0) / static_cast<double>(rounds.size());
    result.p99 = nearestRank(rounds, 99);
    result.most = most;
    constexpr auto kEnd = static_cast<double>(SearchIterations::kHistogramEnd);
    result.histogram.assign(static_cast<size_t>(std::clamp(most, 0.0, kEnd)) + 1, 0);
    for (const double count : rounds)
        ++result.histogram[static_cast<size_t>(std::clamp(count, 0.0, kEnd))];
    return result;
}

Metric searchIterationsMetric() {
    return makeMetric<SearchIterations>({
        .group = "cost",
        .domain = kTestDomain,
        .rows = {{{.key = "iterations_mean",
                   .label = "rounds, mean",
                   .unit = Unit::Rounds,
                   .goal = Goal::Lowest,
                   .meaning = "rounds of the search of a covered pixel's view ray"},
                  &SearchIterations::mean},
                 {{.key = "iterations_p99",
                   .label = "rounds, 99 %",
                   .unit = Unit::Rounds,
                   .goal = Goal::Lowest,
                   .meaning = "99th percentile of it, nearest rank"},
                  &SearchIterations::p99},
                 {{.key = "iterations_max",
                   .label = "rounds, most",
                   .unit = Unit::Rounds,
                   .goal = Goal::Lowest,
                   .meaning = "the most; iterations_histogram counts pixels by rounds"},
                  &SearchIterations::most}},
        .histogramKey = "iterations_histogram",
        .histogram = &SearchIterations::histogram,
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeSearchIterations(input.pair, selection); },
    });
}

} // namespace plumbline
