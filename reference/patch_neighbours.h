// What lies beyond the sides of a patch.
#pragma once

#include "../scenes/base_surface.h"
#include "../scenes/math.h"

#include <optional>
#include <vector>

namespace plumbline {

/// A place on a BaseSurface.
struct PatchPlace {
    int patch = 0;
    Vec2 uv{0};
};

class PatchNeighbours {
  public:
    explicit PatchNeighbours(const BaseSurface& surface);

    /// `uv` outside the patch: the place about as far inside the patch beyond the side that was crossed. A guess to start a
    /// search from: the two patches' scales may differ. Nothing beyond a boundary, or an edge of more than two faces.
    std::optional<PatchPlace> beyond(int patch, const Vec2& uv) const;

  private:
    struct Side {
        int face = -1, k = 0;
    };
    /// Edge k of a face, where `along` in [0,1] runs from its corner k, and `inside` away from the edge.
    PatchPlace placeAt(int face, int k, double along, double inside) const;
    std::optional<PatchPlace> acrossEdge(int face, int k, double along, double inside) const;

    const BaseSurface& surface_;
    std::vector<std::array<Side, 2>> sides_; // per edge
    std::vector<bool> crowded_;              // edges of more than two faces
    std::vector<int> firstPatch_;            // per face
};

} // namespace plumbline
