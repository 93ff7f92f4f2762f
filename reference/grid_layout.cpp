#include "grid_layout.h"

namespace plumbline {

int smallestRate(const BaseSurface& surface) {
    for (const BaseSurface::Patch& patch : surface.patches())
        if (patch.subFace) return 2;
    return 1;
}

MicroMeshSize microMeshSize(const BaseSurface& surface, int rate) {
    MicroMeshSize total;
    for (const BaseSurface::Patch& patch : surface.patches()) {
        const MicroMeshSize size = patchLayoutSize(patch.triangular, patchRate(patch, rate));
        total.microTriangles += size.microTriangles;
        total.vertices += size.vertices;
        total.grids += size.grids;
    }
    return total;
}

MicroMeshSize patchLayoutSize(bool triangular, int cells) {
    MicroMeshSize size;
    const uint64_t squared = static_cast<uint64_t>(cells) * static_cast<uint64_t>(cells);
    size.microTriangles = triangular ? squared : 2 * squared;
    forEachBlock(triangular, cells, [&](int column, int row) {
        size.vertices +=
            static_cast<uint64_t>((blockCells(cells, column) + 1) * (blockCells(cells, row) + 1));
        ++size.grids;
    });
    return size;
}

} // namespace plumbline
