// The error a face would have at a rate, without tessellating it: measured in some of the grids it would be
// cut into.
#pragma once

#include "reference/tessellate/lattice.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"

#include <vector>

namespace plumbline {

/// Part of a patch.
struct PatchRegion {
    int patch = -1;
    Vec2 low{0}, high{1}; // (u, v)
};

struct MeasuredError {
    double world = 0;   // bound of tileError()
    PatchRegion region; // the grid that has it
};

/// Of one object; only for faces that have a limit. Safe to use from many threads.
class FaceErrorProbe {
  public:
    FaceErrorProbe(const BaseSurface& surface, const Relief* relief);

    /// One square patch, which may have other rates along u than along v.
    bool isSquare(int face) const { return !first(face).triangular && !first(face).subFace; }
    int smallestRate(int face) const { return first(face).subFace ? 2 : 1; }
    /// Texels of the relief that the face's edges cross: 0 and 2, and 1 and 3; of a face that isn't square,
    /// all of them twice.
    Vec2 texelsAcross(int face) const;

    /// Of all its grids, the one whose error all but 2 % don't exceed.
    MeasuredError typicalWorst(int face, const Vec2i& rate, BaseSurface::Evaluator& evaluator) const;
    /// The largest of the grids in a region.
    MeasuredError worstWithin(const PatchRegion& region, int face, const Vec2i& rate,
                              BaseSurface::Evaluator& evaluator) const;

  private:
    const BaseSurface::Patch& first(int face) const { return surface_.patch(surface_.firstPatch(face)); }
    MeasuredError measure(int patch, const PatchLattice& lattice, int blockColumn, int blockRow,
                          BaseSurface::Evaluator& evaluator) const;

    const BaseSurface& surface_;
    const Relief* relief_;
    std::vector<MeshFace> faces_;
};

} // namespace plumbline
