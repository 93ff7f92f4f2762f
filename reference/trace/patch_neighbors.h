// What lies beyond the sides of a patch.
#pragma once

#include "scenes/surface/base_surface.h"
#include "scenes/surface/patch_place.h"

#include <optional>
#include <vector>

namespace plumbline {

class PatchNeighbors {
  public:
    explicit PatchNeighbors(const BaseSurface& surface);

    /// `uv` outside the patch: the place about as far inside the patch beyond the side that was crossed. A
    /// guess to start a search from: the two patches' scales may differ. Nothing beyond a boundary, or an
    /// edge of more than two faces.
    std::optional<PatchPlace> beyond(int patch, const Vec2& uv) const;

  private:
    struct Side {
        int face = -1, k = 0;
    };
    std::optional<PatchPlace> acrossEdge(int face, int k, double along, double inside) const;

    const BaseSurface& surface_;
    std::vector<std::array<Side, 2>> sides_; // per edge
    std::vector<bool> crowded_;              // edges of more than two faces
};

} // namespace plumbline
