// What a cone map is made of: for two places of a height map, how steeply the second rises above the first,
// and whether the second matters to a cone that stands on the first.
//
// An offset k = q - p counts texels, wrapped images included (a repeated map is an endless row of itself).
// Lengths are in st units (map widths and heights), heights in relief depth. Slopes are depth per st length:
// a cone of ratio c admits slopes up to 1 / c. Everything is in double; the same functions serve the fast
// search (cone_search.h) and the plain double loop of the tests.
#pragma once

#include "scenes/maps/height_map.h"

#include <algorithm>
#include <vector>

namespace plumbline {

/// Which kind of cone. Quadrants of direction: E, W, N, S = +s, -s, +t, -t, each 45 degrees to both sides in
/// st.
struct ConeRule {
    int sectors = 1;      // 1: all directions in one; 4: E, W, N, S
    bool relaxed = false; // only places where a ray could leave the relief matter
    double rayStart = 0;  // relaxed: 0 = rays may start anywhere outside (safe), 1 = at depth 0 only (2007)
};
inline constexpr int kAllDirections = -1; // instead of a sector

/// The two slices of a cone map (cone_map.h): cones of texel centers, and of whole cells for the bilinear
/// surface.
enum class ConeSlice { Texels, Cells };

/// Box of the gradients of a bilinear patch, depth per texel: (s.x to s.y) x (t.x to t.y). The patch takes
/// all of it, as its slope in s depends on t alone and the other way round. `least`: its least depth.
struct CellSlopes {
    Vec2 s, t;
    double least;
};
CellSlopes cellSlopes(const HeightMap::Cell& cell);

/// Can a ray leave the relief in a cell, when the place it leaves at is k + [-1,1]^2 texels from where its
/// step began? An exit needs a depth that grows along the ray: gradient . offset > 0; for a ray from depth 0,
/// which has sunk by the depth of the place, > that depth.
bool exitPossible(const CellSlopes& cell, int ks, int kt, double rayStart);

class ConePairs {
  public:
    /// Keeps a reference to the map.
    ConePairs(const HeightMap& map, ConeSlice slice, ConeRule rule);

    /// The squared length that a drop over offset k is divided by: |k|^2 in st units, or phi(k)^2 of
    /// cone_map.h for cells.
    double distanceSquared(int ks, int kt) const {
        const double squared = offsetSquared(ks, kt);
        return squared >= closedFormFrom_ ? squared - halfDiagonalSquared_ : nearDistanceSquared(ks, kt);
    }
    double offsetSquared(int ks, int kt) const {
        const double s = ks * perWidth_, t = kt * perHeight_;
        return s * s + t * t;
    }
    /// No offset of at least this squared length has a smaller distanceSquared. Grows with its argument.
    double leastDistanceSquared(double offsetSquared) const {
        return offsetSquared >= closedFormFrom_ ? offsetSquared - halfDiagonalSquared_ : 0.5 * offsetSquared;
    }
    /// Pairs farther apart than this many map sizes along an axis have slopes below 1, the cap of every cone.
    static constexpr int kReachTiles = 2;

    /// Does q = (column, row) + k matter to a cone on (column, row)?
    bool counts(int column, int row, int ks, int kt, int sector) const;
    /// Does any offset of the box matter to the sector?
    bool meetsSector(const Vec2i& low, const Vec2i& high, int sector) const {
        if (sector == kAllDirections) return true;
        const int wider = spread();
        const int along = sector / 2, across = 1 - along;
        const Vec2 size(perWidth_, perHeight_);
        const int farthest = (sector % 2 == 0 ? high[along] : -low[along]) + wider;
        const int nearest = std::max(std::max(low[across], -high[across]) - wider, 0);
        return farthest * size[along] >= nearest * size[across];
    }

    /// Are all true offsets of the pair in the sector?
    bool insideSector(const Vec2i& offset, int sector) const;

    ConeSlice slice() const { return slice_; }
    const ConeRule& rule() const { return rule_; }
    const HeightMap& map() const { return map_; }

  private:
    /// A cell's pair stands for true offsets within a texel of its own along each axis.
    int spread() const { return slice_ == ConeSlice::Cells ? 1 : 0; }
    double nearDistanceSquared(int ks, int kt) const;
    double computeNearDistance(int ks, int kt) const;

    const HeightMap& map_;
    ConeSlice slice_;
    ConeRule rule_;
    double perWidth_, perHeight_;    // st length of a texel
    double halfDiagonalSquared_ = 0; // of a texel; 0 for texel cones
    double closedFormFrom_ = 0;      // squared offsets
    int nearColumns_ = 0;
    std::vector<double> nearSquared_; // by |k_t|, |k_s|
};

} // namespace plumbline
