#include "validate/metrics/fetch_cost.h"

#include "scenes/core/nearest_rank.h"

#include <numeric>

namespace plumbline {
namespace {

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Figure meanOfChannel(const FramePair& pair, ObjectSelection selection, const char* channel) {
    const std::vector<double> values = valuesOnCoveredPixels(pair, selection, channel);
    if (!values.empty()) return meanOf(values);
    return Figure::absent(pair.test().has(channel) ? std::string("the test frame covers no pixel with it")
                                                   : std::string("the test frame has no channel ") + channel);
}

} // namespace

FetchCost computeFetchCost(const FramePair& pair, ObjectSelection selection) {
    FetchCost result;
    result.mean = result.p99 = meanOfChannel(pair, selection, "cost.fetches");
    result.heightMean = meanOfChannel(pair, selection, "cost.fetches.height");
    result.bakedMean = meanOfChannel(pair, selection, "cost.fetches.baked");
    const std::vector<double> costs = valuesOnCoveredPixels(pair, selection, "cost.fetches");
    result.domainPx = costs.size();
    if (!costs.empty()) result.p99 = nearestRank(costs, 99);
    return result;
}

Metric fetchCostMetric() {
    return makeMetric<FetchCost>({
        .group = "cost",
        .domain = kTestDomain,
        .rows = {{{.key = "fetches_mean",
                   .label = "lookups, mean",
                   .unit = Unit::Lookups,
                   .goal = Goal::Lowest,
                   .meaning = "texture lookups in height and baked maps per covered pixel",
                   .table = {{"fetches", 1}},
                   .report = {{"lookups", "per pixel", "{:.1f}"}}},
                  &FetchCost::mean},
                 {{.key = "fetches_p99",
                   .label = "lookups, p99",
                   .unit = Unit::Lookups,
                   .goal = Goal::Lowest,
                   .meaning = "99th percentile of the lookups per covered pixel, nearest rank"},
                  &FetchCost::p99},
                 {{.key = "fetches_px",
                   .label = "pixels with lookups",
                   .unit = Unit::PixelCount,
                   .meaning = "covered pixels counted"},
                  &FetchCost::domainPx},
                 {{.key = "fetches_height_mean",
                   .label = "height lookups",
                   .unit = Unit::Lookups,
                   .goal = Goal::Lowest,
                   .meaning = "mean of the lookups in the height map"},
                  &FetchCost::heightMean},
                 {{.key = "fetches_baked_mean",
                   .label = "baked lookups",
                   .unit = Unit::Lookups,
                   .goal = Goal::Lowest,
                   .meaning = "mean of the lookups in baked maps: cone ratios, distances, normals, bounds"},
                  &FetchCost::bakedMean}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeFetchCost(input.pair, selection); },
    });
}

} // namespace plumbline
