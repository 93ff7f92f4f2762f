// A quadtree over a height map that says of a block of texels how high it can reach: by its least depth, and by a plane below which
// none of its texels lies. Relief depth and texels; no wrapping, that is the caller's.
//
// For relaxed cones it also says so of the texels alone that matter from a given side: an octant of offsets k from the cone's texel to
// here, named by the bits k_s < 0, k_t < 0, |k_t| > |k_s|.
#pragma once

#include "cone_pairs.h"

#include <cstdint>
#include <vector>

namespace plumbline {

class DepthPyramid {
  public:
    static constexpr int kLeafSize = 4;
    static constexpr int kOctants = 8;
    /// Octants say nothing of cells' pairs nearer than this many texels (the larger of |k_s|, |k_t|): from near, a cell is seen from many
    /// sides at once.
    static constexpr int kNearCells = 6;

    explicit DepthPyramid(const ConePairs& pairs);

    /// Bounds of a block for texels seen from one octant, or all of them.
    struct Bound {
        double leastDepth; // infinite: no such texel
        double residual;   // depth >= residual + slope . (texel - centre)
        double leastReach; // none matters to a cone with both |k_s| and |k_t| below this
    };
    struct Plane {
        Vec2 centre; // texels
        Vec2 slope;  // depth per texel
    };
    int levelCount() const { return static_cast<int>(levels_.size()); }
    Vec2i blockCount(int level) const { return levels_[static_cast<size_t>(level)].size; }
    /// Texels low to high, both within the block.
    void block(int level, const Vec2i& at, Vec2i& low, Vec2i& high) const;
    const Plane& plane(int level, const Vec2i& at) const;
    /// `octants`: a bit each; 0 for all texels.
    Bound bound(int level, const Vec2i& at, unsigned octants) const;
    /// The octants that a texel matters from, a bit each; cells from kNearCells on.
    unsigned octantsOf(int column, int row) const;

    /// Octants met by a box of offsets; 0 where octants say nothing.
    unsigned octantsMet(const Vec2i& low, const Vec2i& high) const;
    static double bytesPerTexel(const ConeRule& rule);

  private:
    struct Level {
        Vec2i size{0, 0};
        std::vector<Plane> planes;
        std::vector<Bound> bounds; // classes_ a block: all, then the octants
    };
    size_t blockIndex(const Level& level, const Vec2i& at) const {
        return static_cast<size_t>(at.y) * static_cast<size_t>(level.size.x) + static_cast<size_t>(at.x);
    }
    void rateTexel(int column, int row);
    void makeLeaf(const Vec2i& at);
    void makeParent(int level, const Vec2i& at);

    const ConePairs& pairs_;
    Vec2i mapSize_;
    int classes_; // 1, or 1 + kOctants
    std::vector<Level> levels_;
    std::vector<uint8_t> octants_; // a texel; empty unless relaxed
};

} // namespace plumbline
