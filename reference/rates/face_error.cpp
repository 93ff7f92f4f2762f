#include "reference/rates/face_error.h"

#include "reference/tessellate/tile.h"
#include "scenes/core/nearest_rank.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

FaceErrorProbe::FaceErrorProbe(const BaseSurface& surface, const Relief* relief)
    : surface_(surface), relief_(relief), faces_(surface.mesh().faces()) {}

Vec2 FaceErrorProbe::texelsAcross(int face) const {
    if (!relief_) return Vec2(0);
    const ControlMesh& mesh = surface_.mesh();
    const MeshFace& corners = item(faces_, face);
    const Vec2 texelsOfTile = glm::abs(relief_->tile) * Vec2(relief_->map->width(), relief_->map->height());
    Vec2 texels(0);
    for (size_t k = 0; k < corners.size; ++k) {
        const Vec2 along = mesh.uvAt(corners.corner(k + 1)) - mesh.uvAt(corners.corner(k));
        const Vec2 crossed = glm::abs(along) * texelsOfTile;
        double& most = isSquare(face) && k % 2 == 1 ? texels.y : texels.x;
        most = std::max({most, crossed.x, crossed.y});
    }
    if (!isSquare(face)) texels.y = texels.x;
    return texels;
}

MeasuredError FaceErrorProbe::measure(int patch, const PatchLattice& lattice, int blockColumn, int blockRow,
                                      BaseSurface::Evaluator& evaluator) const {
    Tile tile{};
    tile.patch = patch;
    tile.column0 = blockColumn * kGridCells;
    tile.row0 = blockRow * kGridCells;
    tile.columns = blockCells(lattice.columns, blockColumn);
    tile.rows = blockCells(lattice.rows, blockRow);
    evaluator.setPatch(patch);
    sampleTile(tile, lattice, relief_, evaluator);
    const Vec2 cells(lattice.columns, lattice.rows);
    return {tileError(tile, lattice, relief_, evaluator, 0, 0, tile.columns, tile.rows, false).world,
            {patch, Vec2(tile.column0, tile.row0) / cells,
             Vec2(tile.column0 + tile.columns, tile.row0 + tile.rows) / cells}};
}

MeasuredError FaceErrorProbe::typicalWorst(int face, const Vec2i& rate,
                                           BaseSurface::Evaluator& evaluator) const {
    const PatchLattice lattice = latticeOf(first(face), rate);
    const int patches = first(face).subFace ? item(surface_.mesh().faceSizes, face) : 1;
    const int firstPatch = surface_.firstPatch(face);
    std::vector<MeasuredError> errors;
    for (int patch = firstPatch; patch < firstPatch + patches; ++patch)
        for (int row = 0; row < blocksAlong(lattice.rows); ++row)
            for (int column = 0; column < blocksInRow(lattice, row); ++column)
                errors.push_back(measure(patch, lattice, column, row, evaluator));
    return nearestRankInPlace(errors, 98, &MeasuredError::world);
}

MeasuredError FaceErrorProbe::worstWithin(const PatchRegion& region, int face, const Vec2i& rate,
                                          BaseSurface::Evaluator& evaluator) const {
    const PatchLattice lattice = latticeOf(first(face), rate);
    const Vec2 blocks = Vec2(lattice.columns, lattice.rows) / double(kGridCells);
    const auto firstBlock = [](double at) { return static_cast<int>(std::floor(at)); };
    const auto lastBlock = [](double at) { return std::max(static_cast<int>(std::ceil(at)) - 1, 0); };
    MeasuredError worst{-1, region};
    for (int row = firstBlock(region.low.y * blocks.y); row <= lastBlock(region.high.y * blocks.y); ++row)
        for (int column = firstBlock(region.low.x * blocks.x); column <= lastBlock(region.high.x * blocks.x);
             ++column) {
            if (column >= blocksInRow(lattice, row)) continue; // beyond a triangle's hypotenuse
            const MeasuredError error = measure(region.patch, lattice, column, row, evaluator);
            if (error.world > worst.world) worst = error;
        }
    return worst;
}

} // namespace plumbline
