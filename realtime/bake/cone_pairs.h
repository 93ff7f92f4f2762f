// Pairs of points of a height map, from which cone maps are computed: how steeply the second point rises
// above the first, and whether it constrains a cone whose apex is at the first.
//
// An offset k = q - p is in texels and may refer to a repeated image of the map. Lengths are in st units (map
// widths and heights), heights in relief depth. Slopes are depth per st length: a cone of ratio c admits
// slopes up to 1 / c. All computations are in double precision. The fast search (cone_search.h) and the
// brute-force loop of the tests use the same functions.
#pragma once

#include "scenes/maps/height_map.h"

#include <algorithm>
#include <vector>

namespace plumbline {

/// The kind of cone. The quadrants E, W, N, S are centered at the directions +s, -s, +t, -t and extend 45
/// degrees to both sides in st.
struct ConeRule {
    int sectors = 1;      // 1: all directions; 4: E, W, N, S
    bool relaxed = false; // only points where a ray can exit the relief count
    double rayStart = 0;  // relaxed: 0 = rays may start anywhere outside (safe), 1 = at depth 0 only (2007)
};
inline constexpr int kAllDirections = -1; // instead of a sector

/// The two slices of a cone map (cone_map.h): cones at texel centers, and cones valid in whole cells of the
/// bilinear surface.
enum class ConeSlice { Texels, Cells };

/// The range of gradients of a bilinear patch, depth per texel: (s.x to s.y) x (t.x to t.y). All gradients of
/// this box occur, because the slope in s depends only on t and vice versa. `least`: the patch's minimum
/// depth.
struct CellSlopes {
    Vec2 s, t;
    double least;
};
CellSlopes cellSlopes(const HeightMap::Cell& cell);

/// Whether a ray can exit the relief in a cell at an offset of k + [-1,1]^2 texels from the start of its
/// step. At an exit, the relief's depth must increase along the ray: gradient . offset > 0, or, for a ray
/// from depth 0, which has descended by the depth at the exit, > that depth.
bool exitPossible(const CellSlopes& cell, int ks, int kt, double rayStart);

class ConePairs {
  public:
    /// Keeps a reference to the map.
    ConePairs(const HeightMap& map, ConeSlice slice, ConeRule rule);

    /// The squared distance by which the height difference over offset k is divided: |k|^2 in st units, or
    /// phi(k)^2 of cone_map.h for cells.
    double distanceSquared(int ks, int kt) const {
        const double squared = offsetSquared(ks, kt);
        return squared >= closedFormFrom_ ? squared - halfDiagonalSquared_ : nearDistanceSquared(ks, kt);
    }
    double offsetSquared(int ks, int kt) const {
        const double s = ks * perWidth_, t = kt * perHeight_;
        return s * s + t * t;
    }
    /// Lower bound of distanceSquared over all offsets of at least this squared length. Monotonic.
    double minDistanceSquared(double offsetSquared) const {
        return offsetSquared >= closedFormFrom_ ? offsetSquared - halfDiagonalSquared_ : 0.5 * offsetSquared;
    }
    /// Pairs farther apart than this many map sizes along an axis have slopes below 1, the cap of every cone.
    static constexpr int kReachTiles = 2;

    /// Whether q = (column, row) + k constrains a cone at (column, row).
    bool counts(int column, int row, int ks, int kt, int sector) const;
    /// Whether the box of offsets intersects the sector.
    bool meetsSector(const Vec2i& low, const Vec2i& high, int sector) const {
        if (sector == kAllDirections) return true;
        const int wider = spread();
        const int along = sector / 2, across = 1 - along;
        const Vec2 size(perWidth_, perHeight_);
        const int farthest = (sector % 2 == 0 ? high[along] : -low[along]) + wider;
        const int nearest = std::max(std::max(low[across], -high[across]) - wider, 0);
        return farthest * size[along] >= nearest * size[across];
    }

    /// Whether all actual offsets that the pair represents are in the sector.
    bool insideSector(const Vec2i& offset, int sector) const;

    ConeSlice slice() const { return slice_; }
    const ConeRule& rule() const { return rule_; }
    const HeightMap& map() const { return map_; }

  private:
    /// A pair of cells represents actual offsets within one texel of its own along each axis.
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
