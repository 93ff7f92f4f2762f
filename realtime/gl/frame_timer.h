// Measures the time of a frame as the median of warm runs.
#pragma once

#include "realtime/gl/gl_context.h"

#include <functional>
#include <string>

namespace plumbline {

struct FrameTime {
    double msMedian = 0;
    int runs = 0;
    std::string timer;
};

/// Calls `draw` once to warm up, then until the budget is spent, at least once and at most 25 times. If the
/// first frame takes more than five times the budget, it isn't repeated: its time is returned and `timer`
/// states that it was cold. Uses timer queries on a GPU and the wall clock around glFinish on a software
/// rasterizer, where queries don't measure the work.
FrameTime timeFrame(const GlContext& context, double budgetMs, const std::function<void()>& draw);

} // namespace plumbline
