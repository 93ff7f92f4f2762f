#include "validate/metrics/fetch_cost.h"

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

MetricValues valuesOf(const FetchCost& result) {
    return {{"fetches_mean", result.mean},
            {"fetches_p99", result.p99},
            {"fetches_px", result.domainPx},
            {"fetches_height_mean", result.heightMean},
            {"fetches_baked_mean", result.bakedMean}};
}

} // namespace plumbline
