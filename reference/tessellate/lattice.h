// The lattice of a patch: where its micro-vertices stand, and how it is cut into the grids of a MicroMesh.
//
// A patch has columns x rows cells, both powers of two. A side that it shares with a coarser neighbor has
// fewer samples than the lattice has steps there: the lattice's vertices on that side stand on the nearest of
// those samples, so that neighbors meet in the very same vertices. The cells along such a side are no
// rectangles any more and some of their triangles have no area.
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
/// Grids in one row of them; a triangle has those that touch its lower left half.
inline int blocksInRow(const PatchLattice& lattice, int blockRow) {
    return blocksAlong(lattice.columns) - (lattice.triangular ? blockRow : 0);
}

/// The step a lattice vertex stands on along a side of `cells` steps that has `segments` segments: the
/// nearest multiple of cells / segments.
inline int snappedStep(int step, int cells, int segments) {
    assert(segments > 0 && cells % segments == 0);
    const int stride = cells / segments;
    return (step + stride / 2) / stride * stride;
}

/// Where vertex (column, row) stands, in steps of the lattice: (u, v) is that over (columns, rows). Beyond a
/// triangle's long side it is the point on it in the same column, which leaves no area there.
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

/// (u, v) of the patch at a place, in steps.
inline Vec2 uvOf(const PatchLattice& lattice, const Vec2i& place) {
    return Vec2(place) / Vec2(lattice.columns, lattice.rows);
}
/// (u, v) of the patch at a vertex.
inline Vec2 latticeUv(const PatchLattice& lattice, int column, int row) {
    return uvOf(lattice, latticePlace(lattice, column, row));
}

/// Micro-triangles, vertices and grids of a lattice, without making them. Micro-triangles are those with area
/// in parameter space were no side snapped.
struct MicroMeshSize {
    uint64_t microTriangles = 0;
    uint64_t vertices = 0;
    uint64_t grids = 0;
};

/// Segments per control edge an object is cut into: powers of two, kMostRate at most.
struct Rates {
    /// Of each face: along its edges 0 and 2, and along 1 and 3, for a face that is one square patch; else
    /// two equal numbers for all its edges, at least 2 where the face is cut into sub-faces.
    std::vector<Vec2i> faces;
    /// Of each edge: the smallest its faces have along it, but at least 2 beside a face that is cut into
    /// sub-faces.
    std::vector<int> edges;
};

inline int largestRate(const Rates& rates) {
    int largest = 1;
    for (const Vec2i& rate : rates.faces)
        largest = std::max({largest, rate.x, rate.y});
    return largest;
}

/// Samples are at multiples of 1 / rate: rates are powers of two so that they lie on OpenSubdiv's exact limit
/// points, and not above 2^10, beyond which its approximation of the limit ends.
inline constexpr int kMostRate = 1024;
inline bool isRate(int rate) {
    return rate >= 1 && rate <= kMostRate && std::has_single_bit(static_cast<unsigned>(rate));
}

/// `faceRates` as Rates::faces; fills in the edges.
Rates ratesFromFaces(const BaseSurface& surface, std::vector<Vec2i> faceRates);
/// The lattice of a patch at its face's rates (Rates::faces), no side of it coarser.
PatchLattice latticeOf(const BaseSurface::Patch& patch, const Vec2i& faceRate);

/// The same rate everywhere, but for faces that need more.
Rates uniformRates(const BaseSurface& surface, int rate);

/// The lattice of each patch, in the order of surface.patches().
std::vector<PatchLattice> patchLattices(const BaseSurface& surface, const Rates& rates);

MicroMeshSize microMeshSize(const BaseSurface& surface, const Rates& rates);

} // namespace plumbline
