// A quadtree over a height map that bounds how high a block of texels can reach: by its minimum depth, and by
// a plane that no texel exceeds in height. Units: relief depth and texels. Wrapping is left to the caller.
//
// For relaxed cones it has additional bounds of only those texels that count from a given side, that is, an
// octant of offsets k from the cone's texel to here, identified by the bits k_s < 0, k_t < 0, |k_t| > |k_s|.
#pragma once

#include "realtime/bake/cone_pairs.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace plumbline {

class DepthPyramid {
  public:
    static constexpr int kLeafSize = 4;
    static constexpr int kOctants = 8;
    /// Octants aren't used for pairs of cells nearer than this many texels (the larger of |k_s|, |k_t|),
    /// because a near cell is seen from a wide range of directions.
    static constexpr int kNearCells = 6;

    explicit DepthPyramid(const ConePairs& pairs);

    /// Bounds of a block for the texels that count from one octant, or for all texels.
    struct Bound {
        double minDepth; // infinite: no such texel
        double residual; // depth >= residual + slope . (texel - center)
        double minReach; // no texel counts for cones with both |k_s| and |k_t| below this
    };
    struct Plane {
        Vec2 center;      // texels
        Vec2 slope;       // depth per texel
        double steepness; // length of the slope, depth per st
    };
    int levelCount() const { return static_cast<int>(levels_.size()); }
    Vec2i blockCount(int level) const { return levels_[static_cast<size_t>(level)].size; }
    /// The range of texels of a block, both ends inclusive.
    void block(int level, const Vec2i& at, Vec2i& low, Vec2i& high) const {
        const int side = kLeafSize << level;
        low = at * side;
        high = glm::min(low + side, mapSize_) - 1;
    }
    const Plane& plane(int level, const Vec2i& at) const {
        const Level& l = levels_[static_cast<size_t>(level)];
        return l.planes[blockIndex(l, at)];
    }
    /// Bounds of all texels of a block, then of those that count from each octant (relaxed only).
    const Bound* bounds(int level, const Vec2i& at) const {
        const Level& l = levels_[static_cast<size_t>(level)];
        return &l.bounds[blockIndex(l, at) * static_cast<size_t>(classes_)];
    }
    /// Whether the gradients of the cells around a block's texels allow a ray to exit there, at an offset
    /// between low and high from its start (relaxed only).
    bool exitPossible(int level, const Vec2i& at, const Vec2i& low, const Vec2i& high) const {
        const Level& l = levels_[static_cast<size_t>(level)];
        const CellSlopes& slopes = l.slopes[blockIndex(l, at)];
        const auto largest = [](const Vec2& g, double from, double to) {
            return std::max(std::max(g.x * from, g.x * to), std::max(g.y * from, g.y * to));
        };
        return largest(slopes.s, low.x - spread_, high.x + spread_) +
                   largest(slopes.t, low.y - spread_, high.y + spread_) >
               pairs_.rule().rayStart * slopes.least;
    }
    /// The combined bounds of several octants, given as bits.
    static Bound boundOfOctants(const Bound* bounds, unsigned octants) {
        Bound met{kInfinity, kInfinity, kInfinity};
        for (; octants != 0; octants &= octants - 1) {
            const Bound& b = bounds[1 + std::countr_zero(octants)];
            met.minDepth = std::min(met.minDepth, b.minDepth);
            met.residual = std::min(met.residual, b.residual);
            met.minReach = std::min(met.minReach, b.minReach);
        }
        return met;
    }
    /// The octants from which a texel counts, as bits; for cells at distances from kNearCells on.
    unsigned octantsOf(int column, int row) const {
        return octants_[static_cast<size_t>(row) * static_cast<size_t>(mapSize_.x) +
                        static_cast<size_t>(column)];
    }

    /// Octants that intersect a box of offsets; 0 where octants aren't used.
    unsigned octantsMet(const Vec2i& low, const Vec2i& high) const {
        if (classes_ == 1) return 0;
        const Vec2i nearest = glm::max(glm::max(low, -high), Vec2i(0));
        if (std::max(nearest.x, nearest.y) < nothingBelow_) return 0;
        unsigned met = 0;
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant) {
            const int s0 = quadrant & 1 ? -high.x : low.x, s1 = quadrant & 1 ? -low.x : high.x;
            const int t0 = quadrant & 2 ? -high.y : low.y, t1 = quadrant & 2 ? -low.y : high.y;
            if (s1 < 0 || t1 < 0) continue;
            if (s1 >= std::max(t0, 0)) met |= 1u << quadrant;
            if (t1 >= std::max(s0, 0)) met |= 1u << (quadrant | 4u);
        }
        return met;
    }
    static double bytesPerTexel(const ConeRule& rule);

  private:
    struct Level {
        Vec2i size{0, 0};
        std::vector<Plane> planes;
        std::vector<CellSlopes> slopes; // of all cells around its texels; relaxed only
        std::vector<Bound> bounds;      // classes_ per block: all, then the octants
    };
    size_t blockIndex(const Level& level, const Vec2i& at) const {
        return static_cast<size_t>(at.y) * static_cast<size_t>(level.size.x) + static_cast<size_t>(at.x);
    }
    void rateTexel(int column, int row);
    CellSlopes leafSlopes(const Vec2i& low, const Vec2i& high) const;
    void makeLeaf(const Vec2i& at);
    void makeParent(int level, const Vec2i& at);

    const ConePairs& pairs_;
    Vec2i mapSize_;
    int spread_;       // actual offsets of a pair are within this many texels of its own
    int nothingBelow_; // octants aren't used for smaller offsets, texels
    int classes_;      // 1, or 1 + kOctants
    std::vector<Level> levels_;
    std::vector<uint8_t> octants_; // per texel; empty unless relaxed
};

} // namespace plumbline
