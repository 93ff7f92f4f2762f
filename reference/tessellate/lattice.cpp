#include "reference/tessellate/lattice.h"

#include <cassert>

namespace plumbline {

namespace {

/// The index of the face's rate that applies along its edge k.
int axisOfEdge(const BaseSurface::Patch& patch, int k) {
    return patch.triangular || patch.subFace ? 0 : k % 2;
}

/// Calls visit(face, its first patch).
template <typename Visit>
void forEachFace(const BaseSurface& surface, Visit visit) {
    for (const BaseSurface::Patch& patch : surface.patches())
        if (patch.corner == 0) visit(patch.face, patch);
}

/// The lattice of a patch with the segment counts of its edges. A sub-face has halves of two edges and two
/// interior spokes.
PatchLattice latticeBetween(const BaseSurface& surface, const Rates& rates, const BaseSurface::Patch& patch) {
    PatchLattice lattice = latticeOf(patch, item(rates.faces, patch.face));
    const std::span<const int> edges = surface.faceEdges(patch.face);
    const auto segments = [&](int k, int parts) { // of one part of edge k
        return static_cast<uint16_t>(item(rates.edges, item(edges, k)) / parts);
    };
    const int size = countOf(edges);
    if (patch.subFace) {
        lattice.sides[0] = segments(patch.corner, 2);
        lattice.sides[3] = segments((patch.corner + size - 1) % size, 2);
    } else {
        for (int k = 0; k < size; ++k)
            item(lattice.sides, k) = segments(k, 1);
    }
    return lattice;
}

MicroMeshSize sizeOf(const PatchLattice& lattice) {
    MicroMeshSize size;
    const uint64_t cells = areaOf(lattice.columns, lattice.rows);
    size.microTriangles = lattice.triangular ? cells : 2 * cells;
    for (int row = 0; row < blocksAlong(lattice.rows); ++row)
        for (int column = 0; column < blocksInRow(lattice, row); ++column) {
            size.vertices +=
                areaOf(blockCells(lattice.columns, column) + 1, blockCells(lattice.rows, row) + 1);
            ++size.grids;
        }
    return size;
}

} // namespace

PatchLattice latticeOf(const BaseSurface::Patch& patch, const Vec2i& faceRate) {
    const Vec2i cells = patch.subFace ? faceRate / 2 : faceRate;
    const auto columns = static_cast<uint16_t>(cells.x);
    const auto rows = static_cast<uint16_t>(patch.triangular ? cells.x : cells.y);
    return {columns, rows, {columns, rows, columns, rows}, patch.triangular};
}

Rates ratesFromFaces(const BaseSurface& surface, std::vector<Vec2i> faceRates) {
    Rates rates{std::move(faceRates), std::vector<int>(lengthOf(surface.edgeCount()), kMaxRate)};
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        const Vec2i rate = item(rates.faces, face);
        assert(isRate(rate.x) && isRate(rate.y) && (!patch.subFace || rate.x >= 2));
        int k = 0;
        for (const int edge : surface.faceEdges(face)) {
            int& smallest = item(rates.edges, edge);
            smallest = std::min(smallest, rate[axisOfEdge(patch, k++)]);
        }
    });
    // An edge between a face of rate 1 and sub-faces needs a midpoint, so its rate is at least 2.
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        if (!patch.subFace) return;
        for (const int edge : surface.faceEdges(face))
            item(rates.edges, edge) = std::max(item(rates.edges, edge), 2);
    });
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        Vec2i& rate = item(rates.faces, face);
        int k = 0;
        for (const int edge : surface.faceEdges(face)) {
            int& along = rate[axisOfEdge(patch, k++)];
            along = std::max(along, item(rates.edges, edge));
        }
        if (patch.triangular || patch.subFace) rate.y = rate.x;
    });
    return rates;
}

Rates uniformRates(const BaseSurface& surface, int rate) {
    std::vector<Vec2i> faces(lengthOf(surface.mesh().faceCount()), Vec2i(rate));
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        if (patch.subFace) item(faces, face) = Vec2i(std::max(rate, 2));
    });
    return ratesFromFaces(surface, std::move(faces));
}

std::vector<PatchLattice> patchLattices(const BaseSurface& surface, const Rates& rates) {
    std::vector<PatchLattice> lattices;
    lattices.reserve(surface.patches().size());
    for (const BaseSurface::Patch& patch : surface.patches())
        lattices.push_back(latticeBetween(surface, rates, patch));
    return lattices;
}

MicroMeshSize microMeshSize(const BaseSurface& surface, const Rates& rates) {
    MicroMeshSize total;
    for (const BaseSurface::Patch& patch : surface.patches()) {
        const MicroMeshSize size = sizeOf(latticeBetween(surface, rates, patch));
        total.microTriangles += size.microTriangles;
        total.vertices += size.vertices;
        total.grids += size.grids;
    }
    return total;
}

} // namespace plumbline
