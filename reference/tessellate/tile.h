// A tile: part of a patch's lattice with the true surface sampled at every vertex, from which micro-vertices
// and the bound on their error are made.
#pragma once

#include "reference/tessellate/lattice.h"
#include "reference/tessellate/map_deviation.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"

#include <vector>

namespace plumbline {

/// Grids side by side in a tile: enough that its border, sampled by its neighbors too, costs little.
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
    /// Texels that st within a cell is off from linear between the cell's corners, at most: quads whose uvs
    /// are no parallelogram.
    Vec2 bend;
    std::vector<TileVertex> vertices; // (columns + 1) x (rows + 1), row by row
    /// How far the vertex shared with the neighbors is from the one this patch would have, world units; the
    /// largest of a grid.
    std::vector<double> tears; // as vertices

    size_t index(int column, int row) const { return indexIn(columns + 1, column, row); }
    const TileVertex& at(int column, int row) const { return vertices[index(column, row)]; }
};

/// Fills the tile's vertices. `evaluator`: set to the tile's patch.
void sampleTile(Tile& tile, const PatchLattice& lattice, const Relief* relief,
                const BaseSurface::Evaluator& evaluator);

/// Bound on the distance between the surface and the place of the same (u, v) on the micro-triangles of the
/// tile's cells [column0, column0 + columns) x [row0, row0 + rows), world units.
///
/// With weights w over a micro-triangle's corners, S, k, h at them and P = S + k h,
///     P - sum w P = (S - sum w S) + (k - sum w k) h + (sum w k)(h - sum w h) + sum w k_i (sum w h - h_i):
/// the bows of S and of k (an axis has none), measured at the middles of the edges of some cells, with
/// kBowMargin on top; that of h from the texels, exactly where st is linear over a cell (map_deviation.h),
/// with what its bend can add elsewhere; and a covariance, a quarter of the product of the ranges at most.
struct TileError {
    double world;
    bool torn; // a vertex of it is farther from where its patch would have it than rounding explains
};
TileError tileError(const Tile& tile, const PatchLattice& lattice, const Relief* relief,
                    const BaseSurface::Evaluator& evaluator, int column0, int row0, int columns, int rows);

} // namespace plumbline
