#include "validate/metrics/run_cost.h"

namespace plumbline {
namespace {

const MetricSpec<RunCost>& spec() {
    static const MetricSpec<RunCost> spec{
        .group = "cost",
        .domain = "the technique in this run",
        .scope = Scope::Technique,
        .rows = {{{.key = "bake_ms",
                   .label = "bake time",
                   .unit = Unit::Milliseconds,
                   .goal = Goal::Lowest,
                   .meaning = "time to bake its maps, in this run or when they were added to the cache"},
                  &RunCost::bakeMs},
                 {{.key = "bake_bytes",
                   .label = "bake size",
                   .unit = Unit::Bytes,
                   .goal = Goal::Lowest,
                   .meaning = "size of its baked maps in memory while drawing"},
                  &RunCost::bakeBytes},
                 {{.key = "ms_median",
                   .label = "time",
                   .unit = Unit::Milliseconds,
                   .goal = Goal::Lowest,
                   .meaning = "median time of a frame, warmed up",
                   .table = {{"ms", 1}},
                   .report = {{"time", "ms", "{:.1f}"}}},
                  &RunCost::msMedian}},
    };
    return spec;
}

} // namespace

MetricSet figuresOf(const RunCost& cost) {
    static const Metric metric = runCostMetric();
    MetricSet set;
    set.add(metric, "", measure(spec(), cost));
    return set;
}

Metric runCostMetric() {
    return makeMetric(spec());
}

} // namespace plumbline
