#include "reference/trace/patch_neighbors.h"

#include <algorithm>

namespace plumbline {

PatchNeighbors::PatchNeighbors(const BaseSurface& surface)
    : surface_(surface), sides_(lengthOf(surface.edgeCount())),
      crowded_(lengthOf(surface.edgeCount()), false) {
    for (int face = 0; face < surface.mesh().faceCount(); ++face) {
        if (!surface.hasLimit(face)) continue;
        int k = 0;
        for (const int edge : surface.faceEdges(face)) {
            auto& [first, second] = item(sides_, edge);
            if (second.face >= 0) item(crowded_, edge) = true;
            (first.face < 0 ? first : second) = Side{face, k++};
        }
    }
}

std::optional<PatchPlace> PatchNeighbors::acrossEdge(int face, int k, double along, double inside) const {
    const int edge = item(surface_.faceEdges(face), k);
    if (item(crowded_, edge)) return std::nullopt;
    const auto& [first, second] = item(sides_, edge);
    const Side& other = first.face == face && first.k == k ? second : first;
    if (other.face < 0) return std::nullopt;
    const bool sameWay =
        item(surface_.faceVertices(other.face), other.k) == item(surface_.faceVertices(face), k);
    return placeOnEdge(surface_, other.face, other.k, sameWay ? along : 1 - along, inside);
}

std::optional<PatchPlace> PatchNeighbors::beyond(int patchIndex, const Vec2& uv) const {
    const BaseSurface::Patch& patch = surface_.patch(patchIndex);
    const Vec2 clamped = glm::clamp(uv, Vec2(0), Vec2(1));
    const double over[4] = {-uv.y, patch.triangular ? uv.x + uv.y - 1 : uv.x - 1,
                            patch.triangular ? -kInfinity : uv.y - 1, -uv.x};
    const int side = static_cast<int>(std::max_element(over, over + 4) - over);
    const double inside = over[side];
    if (!(inside > 0)) return std::nullopt;
    if (patch.triangular)
        return acrossEdge(patch.face, side == 3 ? 2 : side,
                          side == 0   ? clamped.x
                          : side == 1 ? clamped.y
                                      : 1 - clamped.y,
                          inside);
    if (!patch.subFace) {
        const double along[4] = {clamped.x, clamped.y, 1 - clamped.x, 1 - clamped.y};
        return acrossEdge(patch.face, side, along[side], inside);
    }
    const int size = countOf(surface_.faceVertices(patch.face));
    const int first = surface_.firstPatch(patch.face);
    const int next = first + (patch.corner + 1) % size, previous = (patch.corner + size - 1) % size;
    switch (side) {
    case 0:
        return acrossEdge(patch.face, patch.corner, clamped.x / 2, inside / 2);
    case 1: // the spoke from the midpoint of this corner's edge, at u = 1 here and at v = 1 in the neighbor
        return PatchPlace{next, {clamped.y, 1 - inside}};
    case 2:
        return PatchPlace{first + previous, {1 - inside, clamped.x}};
    default:
        return acrossEdge(patch.face, previous, 1 - clamped.y / 2, inside / 2);
    }
}

} // namespace plumbline
