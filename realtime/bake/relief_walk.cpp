#include "realtime/bake/relief_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

// Depths closer than this count as equal: above the rounding error of a root, far below any tolerance of a
// check.
constexpr double kSameDepth = 1e-13;

/// (a x + b) x + c.
struct Quadratic {
    double a, b, c;
    double at(double x) const { return (a * x + b) * x + c; }
};

/// Roots strictly between 0 and `length`, in order.
int rootsWithin(const Quadratic& q, double length, std::array<double, 2>& roots) {
    const double discriminant = q.b * q.b - 4 * q.a * q.c;
    if (!(discriminant >= 0)) return 0;
    // First the root without cancellation, then the other one from the product c / a (Vieta).
    const double sum = -0.5 * (q.b + std::copysign(std::sqrt(discriminant), q.b));
    int count = 0;
    const auto take = [&](double root) {
        if (root > 0 && root < length) roots[static_cast<size_t>(count++)] = root;
    };
    if (q.a != 0) take(sum / q.a);
    if (sum != 0) take(q.c / sum);
    if (count == 2 && roots[0] > roots[1]) std::swap(roots[0], roots[1]);
    return count;
}

double largestWithin(const Quadratic& q, double begin, double end) {
    double largest = std::max(q.at(begin), q.at(end));
    const double top = -0.5 * q.b / q.a;
    if (q.a < 0 && top > begin && top < end) largest = std::max(largest, q.at(top));
    return largest;
}

void addInside(std::vector<InsideInterval>& intervals, double begin, double end, double deepest) {
    if (!intervals.empty() && begin <= intervals.back().end + kSameDepth) {
        intervals.back().end = end;
        intervals.back().deepest = std::max(intervals.back().deepest, deepest);
    } else {
        intervals.push_back({begin, end, deepest});
    }
}

/// d - D as a function of the depth from `from` on, in one cell.
Quadratic belowSurface(const HeightMap& map, const Vec2i& cell, const Vec2& texel, const Vec2& step,
                       double from) {
    const HeightMap::Cell c = map.cell(cell.x, cell.y);
    const double slopeX = c.d10 - c.d00, slopeY = c.d01 - c.d00, twist = (c.d11 - c.d01) - slopeX;
    const Vec2 p = texel - Vec2(cell);
    const double surface = c.d00 + slopeX * p.x + slopeY * p.y + twist * p.x * p.y;
    const double rise = slopeX * step.x + slopeY * step.y + twist * (p.x * step.y + p.y * step.x);
    return {-twist * step.x * step.y, 1 - rise, from - surface};
}

} // namespace

/// Crossings of cell borders are computed from the border's index, so rounding errors don't accumulate.
void walkRelief(const HeightMap& map, const DescendingRay& ray, double begin, double end,
                std::vector<InsideInterval>& intervals) {
    intervals.clear();
    const Vec2 size(map.width(), map.height());
    const Vec2 origin = ray.origin * size - 0.5, step = ray.slope * size; // texels from the center of texel 0
    Vec2i cell(glm::floor(origin + begin * step));
    const auto borderDepth = [&](int axis) {
        if (step[axis] == 0) return kInfinity;
        return ((step[axis] > 0 ? cell[axis] + 1 : cell[axis]) - origin[axis]) / step[axis];
    };
    for (double at = begin; at < end;) {
        const Vec2 border(borderDepth(0), borderDepth(1));
        const double next = std::clamp(std::min(border.x, border.y), at, end);
        if (next > at) {
            const Quadratic below = belowSurface(map, cell, origin + at * step, step, at);
            std::array<double, 2> roots;
            const int count = rootsWithin(below, next - at, roots);
            double from = 0;
            for (int k = 0; k <= count; ++k) {
                const double to = k < count ? roots[static_cast<size_t>(k)] : next - at;
                if (below.at(0.5 * (from + to)) > 0) {
                    const double deepest = largestWithin(below, from, to);
                    if (deepest > 0) addInside(intervals, at + from, k < count ? at + to : next, deepest);
                }
                from = to;
            }
        }
        if (next >= end) return;
        const int axis = border.x <= border.y ? 0 : 1;
        cell[axis] += step[axis] > 0 ? 1 : -1;
        at = next;
    }
}

} // namespace plumbline
