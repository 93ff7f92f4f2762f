// The lattice of a patch: the parameter values of its micro-vertices and its division into the grids of a
// MicroMesh.
//
// A patch has columns x rows cells, both powers of two. A side shared with a coarser neighbor has fewer
// samples than the lattice has steps. The lattice's vertices on that side are snapped to the nearest sample,
// so that neighbors have identical vertices. The cells along such a side aren't rectangular, and some of
// their triangles have no area.
#pragma once

#include "scenes/surface/base_surface.h"
#include "scenes/surface/micro_mesh.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace plumbline {

/// Cells of a grid along one side.
inline constexpr int kGridCells = kMaxGridSide - 1;

inline int blocksAlong(int cells) {
    return (cells + kGridCells - 1) / kGridCells;
}
inline int blockCells(int cells, int block) {
    return std::min(kGridCells, cells - block * kGridCells);
}
/// Grids in one row of blocks; a triangular patch has only those that intersect its lower left half.
inline int blocksInRow(const PatchLattice& lattice, int blockRow) {
    return blocksAlong(lattice.columns) - (lattice.triangular ? blockRow : 0);
}

/// Snaps a step along a side of `cells` steps with `segments` segments to the nearest multiple of cells /
/// segments.
inline int snappedStep(int step, int cells, int segments) {
    assert(segments > 0 && cells % segments == 0);
    const int stride = cells / segments;
    return (step + stride / 2) / stride * stride;
}

/// The snapped position of vertex (column, row) in steps of the lattice; (u, v) is the position divided by
/// (columns, rows). Beyond a triangle's hypotenuse it is the point on the hypotenuse in the same column, so
/// that triangles there have no area.
inline Vec2i latticePlace(const PatchLattice& lattice, int column, int row) {
    const int columns = lattice.columns, rows = lattice.rows;
    if (lattice.triangular && column + row >= columns) {
        const int along = snappedStep(columns - std::min(column, columns), columns, lattice.sides[1]);
        return {columns - along, along};
    }
    if (row == 0) return {snappedStep(column, columns, lattice.sides[0]), 0};
    if (column == 0) return {0, snappedStep(row, rows, lattice.sides[lattice.triangular ? 2 : 3])};
    if (row == rows) return {snappedStep(column, columns, lattice.sides[2]), rows};
    if (column == columns) return {columns, snappedStep(row, rows, lattice.sides[1])};
    return {column, row};
}

/// (u, v) of the patch at a position in steps.
inline Vec2 uvOf(const PatchLattice& lattice, const Vec2i& place) {
    return Vec2(place) / Vec2(lattice.columns, lattice.rows);
}
/// (u, v) of the patch at a vertex.
inline Vec2 latticeUv(const PatchLattice& lattice, int column, int row) {
    return uvOf(lattice, latticePlace(lattice, column, row));
}

/// Counts of a lattice's micro-triangles, vertices and grids. Micro-triangles are counted as if no side were
/// snapped.
struct MicroMeshSize {
    uint64_t microTriangles = 0;
    uint64_t vertices = 0;
    uint64_t grids = 0;
};

/// Segments per control edge: powers of two, at most kMaxRate.
struct Rates {
    /// Per face. For a face that is a single square patch: along its edges 0 and 2, and along 1 and 3.
    /// Otherwise two equal numbers for all edges, at least 2 if the face is divided into sub-faces.
    std::vector<Vec2i> faces;
    /// Per edge: the minimum of its faces' rates along it, but at least 2 next to a face that is divided into
    /// sub-faces.
    std::vector<int> edges;
};

inline int largestRate(const Rates& rates) {
    int largest = 1;
    for (const Vec2i& rate : rates.faces)
        largest = std::max({largest, rate.x, rate.y});
    return largest;
}

/// Samples are at multiples of 1 / rate. Rates are powers of two so that OpenSubdiv's limit points are exact
/// there, and at most 2^10, the finest level of its approximation.
inline constexpr int kMaxRate = 1024;
inline bool isRate(int rate) {
    return rate >= 1 && rate <= kMaxRate && std::has_single_bit(static_cast<unsigned>(rate));
}

/// Derives the edge rates. `faceRates` is Rates::faces.
Rates ratesFromFaces(const BaseSurface& surface, std::vector<Vec2i> faceRates);
/// The lattice of a patch at its face's rates (Rates::faces), without coarser sides.
PatchLattice latticeOf(const BaseSurface::Patch& patch, const Vec2i& faceRate);

/// The same rate everywhere, except for faces that need a larger one.
Rates uniformRates(const BaseSurface& surface, int rate);

/// The lattice of each patch, in the order of surface.patches().
std::vector<PatchLattice> patchLattices(const BaseSurface& surface, const Rates& rates);

MicroMeshSize microMeshSize(const BaseSurface& surface, const Rates& rates);

} // namespace plumbline
