// A tile is a part of a patch's lattice with the true surface sampled at every vertex. Micro-vertices and
// their error bound are computed from it.
#pragma once

#include "reference/tessellate/lattice.h"
#include "reference/tessellate/map_deviation.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"

#include <vector>

namespace plumbline {

/// Adjacent grids per tile, enough that the cost of its border, which neighbors sample too, is small.
inline constexpr int kTileGrids = 8;

struct TileVertex {
    Vec3 base{0};      // S, world
    Vec3 direction{0}; // k, unit: the normal, or the relief's axis
    MapPoint map;      // texel coordinates and d; zero without a relief
    double height = 0; // displacement along k, world units
    Vec3 displaced() const { return base + direction * height; }
};

struct Tile {
    int patch;
    int column0, row0; // in the lattice
    int columns, rows; // cells
    /// Bound, in texels, on the deviation of st within a cell from linear interpolation; nonzero for quads
    /// whose uvs aren't a parallelogram.
    Vec2 bend;
    std::vector<TileVertex> vertices; // (columns + 1) x (rows + 1), row by row
    /// Distance between the vertex shared with neighbors and the vertex that this patch alone would have,
    /// world units.
    std::vector<double> tears; // like vertices

    size_t index(int column, int row) const { return indexIn(columns + 1, column, row); }
    const TileVertex& at(int column, int row) const { return vertices[index(column, row)]; }
};

/// Fills the tile's vertices. `evaluator`: set to the tile's patch.
void sampleTile(Tile& tile, const PatchLattice& lattice, const Relief* relief,
                const BaseSurface::Evaluator& evaluator);

/// Bound on the distance between the surface and the point with the same (u, v) on the micro-triangles of the
/// tile's cells [column0, column0 + columns) x [row0, row0 + rows), world units.
///
/// With weights w over a micro-triangle's corners, S, k, h at them and P = S + k h,
///     P - sum w P = (S - sum w S) + (k - sum w k) h + (sum w k)(h - sum w h) + sum w k_i (sum w h - h_i):
/// The terms are the deviations of S and k from linear (0 for an axis), measured at the midpoints of the
/// edges of some cells, and of those where k may jump, and multiplied by kBowMargin; that of h, computed from
/// the texels exactly if st is linear over a cell (map_deviation.h), otherwise enlarged by the effect of its
/// bend; and a covariance, which is at most a quarter of the product of the ranges.
///
/// `corners`: also of the edges at the patch's corners, where bows near singular points of S fall slower than
/// elsewhere; a plan of rates leaves them out, so that it doesn't refine a whole face for them.
struct TileError {
    double world;
    bool torn; // a vertex differs from the one its patch alone would have by more than rounding
};
TileError tileError(const Tile& tile, const PatchLattice& lattice, const Relief* relief,
                    const BaseSurface::Evaluator& evaluator, int column0, int row0, int columns, int rows,
                    bool corners);

} // namespace plumbline
