// Maps parameter values beyond a side of a patch to the neighboring patch.
#pragma once

#include "scenes/surface/base_surface.h"
#include "scenes/surface/patch_place.h"

#include <optional>
#include <vector>

namespace plumbline {

class PatchNeighbors {
  public:
    explicit PatchNeighbors(const BaseSurface& surface);

    /// For `uv` outside the patch, the point about as far inside the neighboring patch across the crossed
    /// side. It is only an initial guess for an iteration, because the patches' parametrizations may differ.
    /// Nothing beyond a boundary or an edge with more than two faces.
    std::optional<PatchPlace> beyond(int patch, const Vec2& uv) const;

  private:
    struct Side {
        int face = -1, k = 0;
    };
    std::optional<PatchPlace> acrossEdge(int face, int k, double along, double inside) const;

    const BaseSurface& surface_;
    std::vector<std::array<Side, 2>> sides_; // per edge
    std::vector<bool> crowded_;              // edges with more than two faces
};

} // namespace plumbline
