#include "scenes/surface/patch_place.h"

#include <cassert>

namespace plumbline {

PatchPlace placeOnEdge(const BaseSurface& surface, int face, int k, double along, double inside) {
    assert(along >= 0 && along <= 1);
    const int first = surface.firstPatch(face);
    const BaseSurface::Patch& patch = surface.patch(first);
    if (patch.subFace) { // the first half is along patch k's u, the second along the next one's v
        const int size = countOf(surface.faceVertices(face));
        return along <= 0.5 ? PatchPlace{first + k, {2 * along, 2 * inside}}
                            : PatchPlace{first + (k + 1) % size, {2 * inside, 2 * (1 - along)}};
    }
    if (patch.triangular)
        return {first, k == 0   ? Vec2(along, inside)
                       : k == 1 ? Vec2(1 - along - inside, along)
                                : Vec2(inside, 1 - along)};
    switch (k) {
    case 0:
        return {first, {along, inside}};
    case 1:
        return {first, {1 - inside, along}};
    case 2:
        return {first, {1 - along, 1 - inside}};
    default:
        return {first, {inside, 1 - along}};
    }
}

} // namespace plumbline
