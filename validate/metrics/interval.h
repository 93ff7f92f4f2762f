// The range of a ratio if the true image is uncertain at some pixels.
//
// Every ratio with an interval is  hits / (hits + misses).  Each pixel contributes one of these outcomes to
// it, independently of the other pixels, written as (hits, hits + misses):
//     nothing (0, 0)    a hit (1, 1)    a miss (0, 1)    two misses (0, 2)
// A certain pixel has one outcome, an uncertain one any of a set. The range is that over all combinations of
// outcomes. Since for h <= n
//     (h+1)/(n+1) >= h/n >= h/(n+1) >= h/(n+2)
// both ends are found pixel by pixel: the highest ratio has a hit where possible, else nothing, else a miss;
// the lowest has two misses where possible, else one, else nothing, else a hit. Combinations with 0/0 have no
// ratio and don't count. If one of the ends would be 0/0, all other combinations contain hits only (all
// ratios are 1) or misses only (all are 0), so the other end applies to both.
#pragma once

#include "validate/metrics/figure.h"

#include <algorithm>

namespace plumbline {

/// Either both ends are values, or both are absent with the reason.
struct Interval {
    Figure low, high;

    static Interval absent(const std::string& reason) {
        return {Figure::absent(reason), Figure::absent(reason)};
    }
    /// Distance of `figure` from the farther end, >= 0; absent without an interval.
    Figure reach(const Figure& figure) const {
        if (!figure) return figure;
        if (!low) return low;
        return {std::max(*figure - *low, *high - *figure)};
    }
};

/// The set of outcomes that a pixel may have.
struct Outcomes {
    bool nothing = false, hit = false, miss = false, twoMisses = false;

    bool certain() const { return int(nothing) + int(hit) + int(miss) + int(twoMisses) == 1; }
};

class RatioRange {
  public:
    /// Adds a pixel; at least one outcome must be possible.
    void add(const Outcomes& possible) {
        uncertainPx_ += !possible.certain();
        if (possible.hit)
            ++best_.hits;
        else if (!possible.nothing)
            best_.misses += possible.miss ? 1 : 2;
        if (possible.twoMisses || possible.miss)
            worst_.misses += possible.twoMisses ? 2 : 1;
        else if (!possible.nothing)
            ++worst_.hits;
    }

    /// Adds the pixels of another range, none of which may have been added before.
    void add(const RatioRange& other) {
        best_.add(other.best_);
        worst_.add(other.worst_);
        uncertainPx_ += other.uncertainPx_;
    }

    /// Number of pixels with more than one outcome.
    uint64_t uncertainPx() const { return uncertainPx_; }

    /// The range of hitWeight * hits / (hitWeight * hits + misses). The weight is 1 for IoU and shares, 2 for
    /// F1, which increases with IoU. `figure`: the ratio computed without uncertainty; if it is absent, so is
    /// the interval.
    Interval of(const Figure& figure, uint64_t hitWeight = 1) const {
        if (!figure) return Interval::absent(figure.reason());
        const Figure worst = worst_.ratio(hitWeight), best = best_.ratio(hitWeight);
        return {worst ? worst : best, best ? best : worst};
    }

  private:
    struct Counts {
        uint64_t hits = 0, misses = 0;
        void add(const Counts& other) {
            hits += other.hits;
            misses += other.misses;
        }
        Figure ratio(uint64_t hitWeight) const {
            return Figure::ratio(hitWeight * hits, hitWeight * hits + misses, "no pixel counts");
        }
    };
    Counts best_, worst_;
    uint64_t uncertainPx_ = 0;
};

} // namespace plumbline
