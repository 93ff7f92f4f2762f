#include "fetch_cost.h"

#include <algorithm>
#include <numeric>

namespace plumbline {

FetchCost computeFetchCost(const FramePair& pair, ObjectSelection selection) {
    FetchCost result;
    result.mean = result.p99 = Figure::absent("the test frame has no channel cost.fetches");
    if (!pair.test().has("cost.fetches")) return result;

    const auto fetches = pair.test().channel("cost.fetches");
    std::vector<double> costs;
    for (const size_t index : selection)
        for (const uint32_t pixel : pair.pixelsOf(index))
            if (pair.testIds()[pixel] == pair.objects()[index].id && std::isfinite(fetches[pixel]))
                costs.push_back(fetches[pixel]);
    result.domainPx = costs.size();
    if (costs.empty()) {
        result.mean = result.p99 = Figure::absent("the test frame covers no pixel with it");
        return result;
    }
    std::sort(costs.begin(), costs.end());
    result.mean = std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
    result.p99 = nearestRank(costs, 99);
    return result;
}

MetricValues valuesOf(const FetchCost& result) {
    return {{"fetches_mean", result.mean}, {"fetches_p99", result.p99}, {"fetches_px", result.domainPx}};
}

} // namespace plumbline
