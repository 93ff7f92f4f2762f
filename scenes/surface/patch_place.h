// Points on a BaseSurface, in particular along a face's edges.
#pragma once

#include "scenes/surface/base_surface.h"

namespace plumbline {

struct PatchPlace {
    int patch = 0;
    Vec2 uv{0};
};

/// A point near edge k of a face that has a limit surface. `along` in [0,1] runs along the edge from corner
/// k; `inside` is the distance from the edge into the face. Both are in edge lengths.
PatchPlace placeOnEdge(const BaseSurface& surface, int face, int k, double along, double inside = 0);

} // namespace plumbline
