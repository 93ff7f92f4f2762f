// How a patch's lattice of (cells + 1)^2 vertices is cut into the grids of a MicroMesh.
#pragma once

#include "../scenes/base_surface.h"
#include "../scenes/micro_mesh.h"

#include <algorithm>

namespace plumbline {

/// Cells of a grid along one side.
inline constexpr int kGridCells = kMaxGridSide - 1;

inline int blocksAlong(int cells) {
    return (cells + kGridCells - 1) / kGridCells;
}
inline int blockCells(int cells, int block) {
    return std::min(kGridCells, cells - block * kGridCells);
}

/// Calls visit(block column, block row) for the grids of a patch, in the order they are stored; a triangle
/// has those that touch its lower left half.
template <typename Visit>
void forEachBlock(bool triangular, int cells, Visit visit) {
    const int blocks = blocksAlong(cells);
    for (int row = 0; row < blocks; ++row)
        for (int column = 0; column < (triangular ? blocks - row : blocks); ++column)
            visit(column, row);
}

/// Segments along one side of a patch at `rate` segments per control edge: half of it for a sub-face.
inline int patchRate(const BaseSurface::Patch& patch, int rate) {
    return patch.subFace ? rate / 2 : rate;
}

/// Smallest rate the mesh can have: 2 if a face is split into sub-faces, else 1.
int smallestRate(const BaseSurface& surface);

/// Micro-triangles and vertices, without making them.
struct MicroMeshSize {
    uint64_t microTriangles = 0;
    uint64_t vertices = 0;
    uint64_t grids = 0;
};
MicroMeshSize patchLayoutSize(bool triangular, int cells);
MicroMeshSize microMeshSize(const BaseSurface& surface, int rate);

} // namespace plumbline
