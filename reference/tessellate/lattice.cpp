#include "reference/tessellate/lattice.h"

#include <cassert>

namespace plumbline {

namespace {

/// Which of the two rates of a face counts along its edge k.
int axisOfEdge(const BaseSurface::Patch& patch, int k) {
    return patch.triangular || patch.subFace ? 0 : k % 2;
}

/// Calls visit(face, its first patch).
template <typename Visit>
void forEachFace(const BaseSurface& surface, Visit visit) {
    for (const BaseSurface::Patch& patch : surface.patches())
        if (patch.corner == 0) visit(patch.face, patch);
}

/// With the sides its edges have. A sub-face has half of two edges, and two spokes that only its own face
/// sees.
PatchLattice latticeBetween(const BaseSurface& surface, const Rates& rates, const BaseSurface::Patch& patch) {
    PatchLattice lattice = latticeOf(patch, rates.faces[static_cast<size_t>(patch.face)]);
    const std::span<const int> edges = surface.faceEdges(patch.face);
    const auto edgeRate = [&](size_t k) {
        return static_cast<uint16_t>(rates.edges[static_cast<size_t>(edges[k])]);
    };
    if (patch.subFace) {
        const size_t k = static_cast<size_t>(patch.corner), previous = (k + edges.size() - 1) % edges.size();
        lattice.sides[0] = static_cast<uint16_t>(edgeRate(k) / 2);
        lattice.sides[3] = static_cast<uint16_t>(edgeRate(previous) / 2);
    } else {
        for (size_t k = 0; k < edges.size(); ++k)
            lattice.sides[k] = edgeRate(k);
    }
    return lattice;
}

MicroMeshSize sizeOf(const PatchLattice& lattice) {
    MicroMeshSize size;
    const uint64_t cells = static_cast<uint64_t>(lattice.columns) * lattice.rows;
    size.microTriangles = lattice.triangular ? cells : 2 * cells;
    for (int row = 0; row < blocksAlong(lattice.rows); ++row)
        for (int column = 0; column < blocksInRow(lattice, row); ++column) {
            size.vertices += static_cast<uint64_t>((blockCells(lattice.columns, column) + 1) *
                                                   (blockCells(lattice.rows, row) + 1));
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
    Rates rates{std::move(faceRates), std::vector<int>(static_cast<size_t>(surface.edgeCount()), kMostRate)};
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        const Vec2i rate = rates.faces[static_cast<size_t>(face)];
        assert(isRate(rate.x) && isRate(rate.y) && (!patch.subFace || rate.x >= 2));
        int k = 0;
        for (const int edge : surface.faceEdges(face)) {
            int& smallest = rates.edges[static_cast<size_t>(edge)];
            smallest = std::min(smallest, rate[axisOfEdge(patch, k++)]);
        }
    });
    // An edge between a whole face of rate 1 and sub-faces has a middle all the same.
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        if (!patch.subFace) return;
        for (const int edge : surface.faceEdges(face))
            rates.edges[static_cast<size_t>(edge)] = std::max(rates.edges[static_cast<size_t>(edge)], 2);
    });
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        Vec2i& rate = rates.faces[static_cast<size_t>(face)];
        int k = 0;
        for (const int edge : surface.faceEdges(face)) {
            int& along = rate[axisOfEdge(patch, k++)];
            along = std::max(along, rates.edges[static_cast<size_t>(edge)]);
        }
        if (patch.triangular || patch.subFace) rate.y = rate.x;
    });
    return rates;
}

Rates uniformRates(const BaseSurface& surface, int rate) {
    std::vector<Vec2i> faces(static_cast<size_t>(surface.mesh().faceCount()), Vec2i(rate));
    forEachFace(surface, [&](int face, const BaseSurface::Patch& patch) {
        if (patch.subFace) faces[static_cast<size_t>(face)] = Vec2i(std::max(rate, 2));
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
