// Places on a BaseSurface, and where the places along a face's edges are.
#pragma once

#include "scenes/surface/base_surface.h"

namespace plumbline {

struct PatchPlace {
    int patch = 0;
    Vec2 uv{0};
};

/// Edge k of a face that has a limit surface: `along` in [0,1] runs from its corner k, `inside` away from the
/// edge, in edge lengths.
PatchPlace placeOnEdge(const BaseSurface& surface, int face, int k, double along, double inside = 0);

} // namespace plumbline
