#include "realtime/gl/frame_timer.h"

#include "realtime/gl/gl_objects.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace plumbline {
namespace {

constexpr size_t kMaxRuns = 25;
// If the first frame, which includes the driver's compilation, takes more than this multiple of the budget,
// it isn't repeated.
constexpr double kMaxBudgets = 5;

double wallMs(const std::function<void()>& draw) {
    using Clock = std::chrono::steady_clock;
    glFinish();
    const Clock::time_point start = Clock::now();
    draw();
    glFinish();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double queryMs(const std::function<void()>& draw) {
    const GlQuery query = GlQuery::make();
    glBeginQuery(GL_TIME_ELAPSED, query.get());
    draw();
    glEndQuery(GL_TIME_ELAPSED);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query.get(), GL_QUERY_RESULT, &nanoseconds); // waits
    return static_cast<double>(nanoseconds) * 1e-6;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

} // namespace

FrameTime timeFrame(const GlContext& context, double budgetMs, const std::function<void()>& draw) {
    const bool software = context.softwareRasterizer();
    const std::string timer = software ? "wall clock around glFinish" : "gpu timer query";
    const double firstMs = wallMs(draw);
    if (firstMs > kMaxBudgets * budgetMs) return {firstMs, 1, "wall clock around glFinish, one cold run"};
    std::vector<double> times;
    double spentMs = 0; // wall clock, because queries don't include the driver's work
    while (times.empty() || (spentMs < budgetMs && times.size() < kMaxRuns)) {
        double queriedMs = 0;
        const double ms = wallMs([&] { software ? draw() : static_cast<void>(queriedMs = queryMs(draw)); });
        times.push_back(software ? ms : queriedMs);
        spentMs += ms;
    }
    return {median(times), static_cast<int>(times.size()), timer};
}

} // namespace plumbline
