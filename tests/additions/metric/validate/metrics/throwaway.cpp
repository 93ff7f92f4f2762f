#include "validate/metrics/throwaway.h"

namespace plumbline {

Throwaway computeThrowaway(const FramePair& pair, ObjectSelection selection) {
    Throwaway result;
    for (const size_t index : selection)
        for (const uint32_t pixel : pair.pixelsOf(index))
            result.sharedPx += pair.referenceIds()[pixel] == pair.testIds()[pixel];
    return result;
}

Metric throwawayMetric() {
    return makeMetric<Throwaway>({
        .group = "throwaway",
        .domain = "all pixels",
        .rows = {{{.key = "shared_px",
                   .label = "shared",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Highest,
                   .meaning = "pixels that show the object in both frames",
                   .table = {{"shared", 0}},
                   .report = {{"throw-away", "px", "{:.0f}"}}},
                  &Throwaway::sharedPx}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeThrowaway(input.pair, selection); },
    });
}

} // namespace plumbline
