#include "realtime/bake/depth_pyramid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

// Bounds of rounding errors: of a residual in relief depth, of a reach as a fraction; far above 2^-52.
constexpr double kResidualSlack = 1e-14, kReachSlack = 1e-9;

/// Range of directions of an octant: the ratio of the smaller to the larger component, and how far the larger
/// one extends beyond |k|.
struct OctantRange {
    double leastRatio, mostRatio, beyond;
};

/// Cells: offsets within a texel of k along both axes, |k| >= kNearCells.
OctantRange octantRange(ConeSlice slice) {
    if (slice == ConeSlice::Texels) return {0, 1, 0};
    constexpr double n = DepthPyramid::kNearCells;
    return {-1 / (n - 1), (n + 1) / (n - 1), 1};
}

/// Maximum increase of depth per texel of the larger component over the octant; none if <= 0.
double fastestGrowth(double larger, double smaller, const OctantRange& range) {
    return larger + std::max(range.leastRatio * smaller, range.mostRatio * smaller);
}

struct OctantUse {
    bool matters = false;
    double minReach = kInfinity;
};

void useSlope(OctantUse& use, const Vec2& slope, double depth, unsigned octant, double rayStart,
              const OctantRange& range) {
    const double s = octant & 1 ? -slope.x : slope.x, t = octant & 2 ? -slope.y : slope.y;
    const double growth = octant & 4 ? fastestGrowth(t, s, range) : fastestGrowth(s, t, range);
    const double slack = range.beyond > 0 ? kReachSlack * (std::abs(s) + std::abs(t)) : 0;
    if (!(growth + slack > 0)) return;
    use.matters = true;
    const double reach = rayStart * depth / (growth + slack) * (1 - kReachSlack) - range.beyond;
    use.minReach = std::min(use.minReach, reach);
}

OctantUse octantUse(const ConePairs& pairs, int i, int j, unsigned octant) {
    const HeightMap& map = pairs.map();
    const OctantRange range = octantRange(pairs.slice());
    OctantUse use;
    if (pairs.slice() == ConeSlice::Texels) {
        // The one-sided difference toward the octant, as a slope along +s, +t.
        const int ds = octant & 1 ? -1 : 1, dt = octant & 2 ? -1 : 1;
        const double depth = map.texel(i, j);
        const Vec2 slope(ds * (map.texel(i + ds, j) - depth), dt * (map.texel(i, j + dt) - depth));
        useSlope(use, slope, depth, octant, pairs.rule().rayStart, range);
        return use;
    }
    for (int dj = -1; dj <= 0; ++dj)
        for (int di = -1; di <= 0; ++di) {
            const CellSlopes cell = cellSlopes(map.cell(i + di, j + dj));
            for (const double s : {cell.s.x, cell.s.y})
                for (const double t : {cell.t.x, cell.t.y})
                    useSlope(use, {s, t}, cell.least, octant, pairs.rule().rayStart, range);
        }
    return use;
}

CellSlopes join(const CellSlopes& a, const CellSlopes& b) {
    return {{std::min(a.s.x, b.s.x), std::max(a.s.y, b.s.y)},
            {std::min(a.t.x, b.t.x), std::max(a.t.y, b.t.y)},
            std::min(a.least, b.least)};
}

} // namespace

double DepthPyramid::bytesPerTexel(const ConeRule& rule) {
    const double classes = rule.relaxed ? 1 + kOctants : 1;
    return (classes * sizeof(Bound) + sizeof(Plane) + sizeof(CellSlopes)) / (kLeafSize * kLeafSize) * 4 / 3 +
           1;
}

DepthPyramid::DepthPyramid(const ConePairs& pairs)
    : pairs_(pairs), mapSize_(pairs.map().width(), pairs.map().height()),
      spread_(pairs.slice() == ConeSlice::Cells ? 1 : 0),
      nothingBelow_(pairs.slice() == ConeSlice::Cells ? kNearCells : 0),
      classes_(pairs.rule().relaxed ? 1 + kOctants : 1) {
    if (classes_ > 1) {
        octants_.resize(pairs.map().depths().size());
        tbb::parallel_for(0, mapSize_.y, [&](int row) {
            for (int column = 0; column < mapSize_.x; ++column)
                rateTexel(column, row);
        });
    }
    Vec2i size = (mapSize_ + kLeafSize - 1) / kLeafSize;
    for (int level = 0;; ++level) {
        const size_t count = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
        levels_.push_back(
            {size, std::vector<Plane>(count), std::vector<CellSlopes>(classes_ > 1 ? count : 0),
             std::vector<Bound>(count * static_cast<size_t>(classes_), {kInfinity, kInfinity, kInfinity})});
        tbb::parallel_for(0, size.y, [&](int row) {
            for (int column = 0; column < size.x; ++column)
                level == 0 ? makeLeaf({column, row}) : makeParent(level, {column, row});
        });
        if (size.x == 1 && size.y == 1) break;
        size = (size + 1) / 2;
    }
}

void DepthPyramid::rateTexel(int column, int row) {
    unsigned bits = 0;
    for (unsigned octant = 0; octant < kOctants; ++octant)
        if (octantUse(pairs_, column, row, octant).matters) bits |= 1u << octant;
    octants_[static_cast<size_t>(row) * static_cast<size_t>(mapSize_.x) + static_cast<size_t>(column)] =
        static_cast<uint8_t>(bits);
}

CellSlopes DepthPyramid::leafSlopes(const Vec2i& low, const Vec2i& high) const {
    CellSlopes slopes = cellSlopes(pairs_.map().cell(low.x, low.y));
    for (int j = low.y - 1; j <= high.y; ++j)
        for (int i = low.x - 1; i <= high.x; ++i)
            slopes = join(slopes, cellSlopes(pairs_.map().cell(i, j)));
    return slopes;
}

void DepthPyramid::makeLeaf(const Vec2i& at) {
    Level& level = levels_[0];
    Vec2i low, high;
    block(0, at, low, high);
    const HeightMap& map = pairs_.map();
    const auto depthAt = [&](int i, int j) { return double(map.texel(i, j)); };
    Plane plane{0.5 * Vec2(low + high), Vec2(0), 0};
    if (high.x > low.x)
        plane.slope.x = 0.5 *
                        (depthAt(high.x, low.y) - depthAt(low.x, low.y) + depthAt(high.x, high.y) -
                         depthAt(low.x, high.y)) /
                        (high.x - low.x);
    if (high.y > low.y)
        plane.slope.y = 0.5 *
                        (depthAt(low.x, high.y) - depthAt(low.x, low.y) + depthAt(high.x, high.y) -
                         depthAt(high.x, low.y)) /
                        (high.y - low.y);
    Bound* bounds = &level.bounds[blockIndex(level, at) * static_cast<size_t>(classes_)];
    for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i) {
            const double depth = depthAt(i, j);
            const double residual = depth - glm::dot(plane.slope, Vec2(i, j) - plane.center) - kResidualSlack;
            const auto take = [&](Bound& b, double reach) {
                b.minDepth = std::min(b.minDepth, depth);
                b.residual = std::min(b.residual, residual);
                b.minReach = std::min(b.minReach, reach);
            };
            take(bounds[0], 0);
            if (classes_ == 1) continue;
            const unsigned octants = octantsOf(i, j);
            for (unsigned octant = 0; octant < kOctants; ++octant)
                if (octants >> octant & 1) take(bounds[1 + octant], octantUse(pairs_, i, j, octant).minReach);
        }
    if (classes_ > 1) level.slopes[blockIndex(level, at)] = leafSlopes(low, high);
    plane.steepness = glm::length(plane.slope * Vec2(mapSize_));
    level.planes[blockIndex(level, at)] = plane;
}

void DepthPyramid::makeParent(int levelIndex, const Vec2i& at) {
    Level& level = levels_[static_cast<size_t>(levelIndex)];
    const Level& finer = levels_[static_cast<size_t>(levelIndex - 1)];
    Vec2i low, high;
    block(levelIndex, at, low, high);
    Plane plane{0.5 * Vec2(low + high), Vec2(0), 0};
    const Vec2i childHigh = glm::min(2 * at + 1, finer.size - 1);
    double area = 0;
    const auto forEachChild = [&](auto visit) {
        for (int y = 2 * at.y; y <= childHigh.y; ++y)
            for (int x = 2 * at.x; x <= childHigh.x; ++x) {
                Vec2i childLow, childEnd;
                block(levelIndex - 1, {x, y}, childLow, childEnd);
                visit(blockIndex(finer, {x, y}), childEnd - childLow);
            }
    };
    forEachChild([&](size_t child, const Vec2i& span) {
        const double childArea = (span.x + 1.0) * (span.y + 1.0);
        plane.slope += childArea * finer.planes[child].slope;
        if (classes_ > 1) {
            CellSlopes& slopes = level.slopes[blockIndex(level, at)];
            slopes = area == 0 ? finer.slopes[child] : join(slopes, finer.slopes[child]);
        }
        area += childArea;
    });
    plane.slope /= area;
    Bound* bounds = &level.bounds[blockIndex(level, at) * static_cast<size_t>(classes_)];
    forEachChild([&](size_t child, const Vec2i& span) {
        const Plane& childPlane = finer.planes[child];
        // The child's plane relative to this one is linear, so its minimum is at a corner of the child.
        const Vec2 tilt = glm::abs(childPlane.slope - plane.slope);
        const double shift = -glm::dot(plane.slope, childPlane.center - plane.center) -
                             0.5 * glm::dot(tilt, Vec2(span)) - kResidualSlack;
        for (int c = 0; c < classes_; ++c) {
            const Bound& from = finer.bounds[child * static_cast<size_t>(classes_) + static_cast<size_t>(c)];
            bounds[c].minDepth = std::min(bounds[c].minDepth, from.minDepth);
            bounds[c].residual = std::min(bounds[c].residual, from.residual + shift);
            bounds[c].minReach = std::min(bounds[c].minReach, from.minReach);
        }
    });
    plane.steepness = glm::length(plane.slope * Vec2(mapSize_));
    level.planes[blockIndex(level, at)] = plane;
}

} // namespace plumbline
