// Estimates the error of a face at a given rate without tessellating it, by measuring some of the grids into
// which it would be divided.
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
    double world = 0;   // the bound of tileError()
    PatchRegion region; // the grid with this error
};

/// For the faces of one object that have a limit surface. Safe for concurrent use.
class FaceErrorProbe {
  public:
    FaceErrorProbe(const BaseSurface& surface, const Relief* relief);

    /// Whether the face is a single square patch, which may have different rates along u and v.
    bool isSquare(int face) const { return !first(face).triangular && !first(face).subFace; }
    int smallestRate(int face) const { return first(face).subFace ? 2 : 1; }
    /// Texels of the relief along the face's edges: the maximum for edges 0 and 2, and for edges 1 and 3. For
    /// a face that isn't square, both are the maximum for all edges.
    Vec2 texelsAcross(int face) const;

    /// The 98th percentile of the errors of all of its grids.
    MeasuredError typicalWorst(int face, const Vec2i& rate, BaseSurface::Evaluator& evaluator) const;
    /// The largest error of the grids in a region.
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
