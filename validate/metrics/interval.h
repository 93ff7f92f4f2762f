// The range a ratio can have when the truth isn't certain at every pixel.
//
// Every ratio with an interval is  hits / (hits + misses),  and each pixel adds to it, by itself, one of a
// few outcomes:
//     nothing (0, 0)    a hit (1, 1)    a miss (0, 1)    two misses (0, 2)        as (hits, hits + misses)
// For a certain pixel that is one; for an uncertain one any of a set. The range is over all choices, each
// pixel's independent of the others'. With h <= n it is reached by choosing pixel by pixel:
//     (h+1)/(n+1) >= h/n >= h/(n+1) >= h/(n+2)
// so the highest ratio takes a hit where it may, else nothing, else a miss; the lowest two misses, else one,
// else nothing, else a hit. Choices that leave 0/0 have no ratio and don't count: they are all there is but
// for hits (then every ratio is 1) or but for misses (then every one is 0).
#pragma once

#include "validate/metrics/figure.h"

#include <algorithm>

namespace plumbline {

/// Both ends are values or both are absent, with the reason.
struct Interval {
    Figure low, high;

    static Interval absent(const std::string& reason) {
        return {Figure::absent(reason), Figure::absent(reason)};
    }
    /// How far `figure` is from the farther end, 0 or more; absent without an interval.
    Figure reach(const Figure& figure) const {
        if (!figure) return figure;
        if (!low) return low;
        return {std::max(*figure - *low, *high - *figure)};
    }
};

/// Outcomes a pixel may have.
struct Outcomes {
    bool nothing = false, hit = false, miss = false, twoMisses = false;

    bool certain() const { return int(nothing) + int(hit) + int(miss) + int(twoMisses) == 1; }
};

class RatioRange {
  public:
    /// One pixel, of which at least one outcome must be possible.
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

    /// The pixels of another range, none of them added here already.
    void add(const RatioRange& other) {
        best_.add(other.best_);
        worst_.add(other.worst_);
        uncertainPx_ += other.uncertainPx_;
    }

    /// Pixels added that have more than one outcome.
    uint64_t uncertainPx() const { return uncertainPx_; }

    /// The range of hitWeight * hits / (hitWeight * hits + misses): weight 1 for IoU and shares, 2 for F1,
    /// which rises with IoU. `figure`: the ratio of the reference as it stands; where it is absent, so is the
    /// interval.
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
