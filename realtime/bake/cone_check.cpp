#include "realtime/bake/cone_check.h"

#include "realtime/bake/cone_map.h"
#include "scenes/core/error.h"
#include "scenes/maps/bilinear.h"
#include "scenes/maps/map_texels.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr int kMaxSteps = 200;
constexpr double kMinSlope = 0.01, kMaxSlope = 10; // st per depth

// Clearance, in relief depth, at which a ray counts as having reached the surface: well above rounding errors
// and well below the depths by which overshoots are classified.
constexpr double kTouching = 1e-9;

struct CheckRay {
    DescendingRay line;
    double start; // depth
};

double drawUnit(uint64_t seed, uint64_t ray, uint64_t purpose) {
    return static_cast<double>(mixBits(mixBits(seed) ^ (ray * 8 + purpose)) >> 11) * 0x1p-53;
}

CheckRay drawRay(const HeightMap& map, uint64_t seed, uint64_t ray) {
    const auto draw = [&](uint64_t purpose) { return drawUnit(seed, ray, purpose); };
    const Vec2 st(draw(0), draw(1));
    const double turns = draw(2), slope = kMinSlope * std::pow(kMaxSlope / kMinSlope, draw(3));
    const double start = ray % 2 == 0 ? 0 : draw(4) * map.depth(st);
    const Vec2 perDepth = slope * Vec2(sineOfTurns(turns + 0.25), sineOfTurns(turns));
    return {{st - start * perDepth, perDepth}, start};
}

/// Quadrant of a direction: E, W, N, S.
int quadrantOf(const Vec2& direction) {
    if (std::abs(direction.x) >= std::abs(direction.y)) return direction.x >= 0 ? 0 : 1;
    return direction.y >= 0 ? 2 : 3;
}

double ratioAt(const HeightMap& map, const BakedMap& cones, ConeLookup lookup, int channel, const Vec2& st) {
    const TexelPair s = texelPair(st.x, map.width(), map.wrapS()),
                    t = texelPair(st.y, map.height(), map.wrapT());
    const auto texel = [&](int column, int row) {
        return static_cast<double>(cones.at(0, kConeTexels, column, row)[channel]);
    };
    switch (lookup) {
    case ConeLookup::Cell:
        return static_cast<double>(cones.at(0, kConeCells, s.first, t.first)[channel]);
    case ConeLookup::Nearest:
        return texel(s.weight < 0.5 ? s.first : s.second, t.weight < 0.5 ? t.first : t.second);
    case ConeLookup::MinOfFour:
        return std::min(std::min(texel(s.first, t.first), texel(s.second, t.first)),
                        std::min(texel(s.first, t.second), texel(s.second, t.second)));
    case ConeLookup::Bilinear:
        break;
    }
    return std::lerp(std::lerp(texel(s.first, t.first), texel(s.second, t.first), s.weight),
                     std::lerp(texel(s.first, t.second), texel(s.second, t.second), s.weight), t.weight);
}

/// Depths that a ray visits, beginning with its start.
struct Visits {
    std::array<double, kMaxSteps + 1> depths;
    int count = 0;
    bool inside = false; // the last one is inside
    int arrivalSteps = -1;
};

Visits stepRay(const HeightMap& map, const BakedMap& cones, ConeLookup lookup, const CheckRay& ray) {
    const double slope = glm::length(ray.line.slope);
    const int channel = cones.channels == 1 ? 0 : quadrantOf(ray.line.slope);
    Visits visits;
    double depth = ray.start;
    for (int step = 0; step <= kMaxSteps; ++step) {
        visits.depths[static_cast<size_t>(visits.count++)] = depth;
        const Vec2 st = ray.line.at(depth);
        const double clearance = map.depth(st) - depth;
        visits.inside = clearance < 0;
        if (clearance <= ConeCheck::kArrived && visits.arrivalSteps < 0) visits.arrivalSteps = step;
        if (clearance < kTouching || depth >= 1) break;
        const double ratio = ratioAt(map, cones, lookup, channel, st);
        depth = std::min(depth + ratio * clearance / (slope + ratio), 1.0);
    }
    return visits;
}

/// Largest depth of the ray below the surface between two depths; 0 if it stays outside.
double deepestWithin(const HeightMap& map, const DescendingRay& ray, double from, double to,
                     std::vector<InsideInterval>& scratch) {
    walkRelief(map, ray, from, to, scratch);
    double deepest = 0;
    for (const InsideInterval& interval : scratch)
        deepest = std::max(deepest, interval.deepest);
    return deepest;
}

struct Tally {
    ConeCheck check;
    uint64_t deepestIndex = 0; // of its ray; the first one for equal depths

    void addOvershoot(double deepest, const CheckRay& ray, uint64_t index, double from, double to) {
        ++check.overshoots;
        size_t bin = 0;
        while (bin + 1 < ConeCheck::kDepths.size() && deepest > ConeCheck::kDepths[bin])
            ++bin;
        ++check.overshootsByDepth[bin];
        if (deepest <= check.deepest) return;
        check.deepest = deepest;
        check.deepestRay = ray.line;
        check.deepestFrom = from;
        check.deepestTo = to;
        deepestIndex = index;
    }

    void join(const Tally& other) {
        const ConeCheck& o = other.check;
        check.rays += o.rays;
        check.pierced += o.pierced;
        check.overshootingRays += o.overshootingRays;
        check.overshoots += o.overshoots;
        for (size_t i = 0; i < o.overshootsByDepth.size(); ++i)
            check.overshootsByDepth[i] += o.overshootsByDepth[i];
        check.arrived += o.arrived;
        check.arrivalSteps += o.arrivalSteps;
        if (o.deepest > check.deepest || (o.deepest == check.deepest && other.deepestIndex < deepestIndex)) {
            check.deepest = o.deepest;
            check.deepestRay = o.deepestRay;
            check.deepestFrom = o.deepestFrom;
            check.deepestTo = o.deepestTo;
            deepestIndex = other.deepestIndex;
        }
    }
};

/// Buffers reused for all rays of a thread.
struct Scratch {
    std::vector<InsideInterval> intervals, part;
};

/// If the exact traversal and the lookup at a visited point disagree about a point on the surface, the
/// visited point decides: a ray that was found outside may have touched the surface there.
void checkRay(const HeightMap& map, const BakedMap& cones, ConeLookup lookup, bool relaxed, uint64_t seed,
              uint64_t index, Tally& tally, Scratch& scratch) {
    const CheckRay ray = drawRay(map, seed, index);
    const Visits visits = stepRay(map, cones, lookup, ray);
    ++tally.check.rays;
    if (visits.arrivalSteps >= 0) {
        ++tally.check.arrived;
        tally.check.arrivalSteps += static_cast<uint64_t>(visits.arrivalSteps);
    }
    const auto count = static_cast<size_t>(visits.count);
    walkRelief(map, ray.line, ray.start, visits.depths[count - 1], scratch.intervals);
    if (!scratch.intervals.empty() || visits.inside || visits.depths[count - 1] < 1) ++tally.check.pierced;
    const uint64_t overshootsBefore = tally.check.overshoots;
    size_t k = 0;
    for (size_t step = 1; step < count && k < scratch.intervals.size(); ++step) {
        const double from = visits.depths[step - 1], to = visits.depths[step];
        double deepest = 0;
        for (; k < scratch.intervals.size() && scratch.intervals[k].begin < to; ++k) {
            const InsideInterval& inside = scratch.intervals[k];
            const bool passed = inside.end < to || (step + 1 < count || !visits.inside);
            if (relaxed && !passed) continue; // the step ended inside the interval
            deepest =
                std::max(deepest, inside.end <= to ? inside.deepest
                                                   : deepestWithin(map, ray.line, from, to, scratch.part));
        }
        if (deepest > 0) tally.addOvershoot(deepest, ray, index, from, to);
    }
    if (tally.check.overshoots > overshootsBefore) ++tally.check.overshootingRays;
}

} // namespace

ConeCheck checkCones(const HeightMap& map, const BakedMap& cones, ConeLookup lookup, bool relaxed,
                     uint64_t rays, uint64_t seed) {
    const ConeRule rule = coneRule(cones.kind); // throws for other kinds
    const BakedMap::Level* finest = cones.levels.empty() ? nullptr : &cones.levels[0];
    if (!finest || finest->width != map.width() || finest->height != map.height() ||
        cones.channels != rule.sectors)
        throw InputError(
            "cone map of " + map.name(),
            finest ? fmt::format("{} x {} texels, {} channels", finest->width, finest->height, cones.channels)
                   : "no levels",
            fmt::format("{} x {} texels, {} channels", map.width(), map.height(), rule.sectors));
    return tbb::parallel_reduce(
               tbb::blocked_range<uint64_t>(0, rays, 4096), Tally{},
               [&](const tbb::blocked_range<uint64_t>& range, Tally tally) {
                   Scratch scratch;
                   for (uint64_t index = range.begin(); index < range.end(); ++index)
                       checkRay(map, cones, lookup, relaxed, seed, index, tally, scratch);
                   return tally;
               },
               [](Tally a, const Tally& b) {
                   a.join(b);
                   return a;
               })
        .check;
}

} // namespace plumbline
