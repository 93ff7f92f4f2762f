// How long one frame takes: median of warm runs.
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

/// Calls `draw` once to warm up, then until the budget is spent, at least once and at most 25 times. A first
/// frame that takes five budgets isn't drawn again: its only run counts, and `timer` says it was cold. Timer
/// queries on a GPU; wall clock around glFinish on a software rasterizer, where queries don't measure the
/// work.
FrameTime timeFrame(const GlContext& context, double budgetMs, const std::function<void()>& draw);

} // namespace plumbline
