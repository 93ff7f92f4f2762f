// What a scene written for an unknown mesh has to know of its surface: where it is, which way it faces, how
// finely its texture coordinates map it, how tightly it bends. Measured on samples of the limit surface, each
// standing for a piece of its area. Space: that of the mesh given.
#pragma once

#include "scenes/surface/base_surface.h"

#include <optional>
#include <vector>

namespace plumbline {

struct SurfacePiece {
    Vec3 normal; // unit, outward
    double area; // square world units, > 0
};

struct SurfaceSurvey {
    std::vector<BasePoint> samples;   // corners of the pieces
    std::vector<SurfacePiece> pieces; // not empty
    Bounds bounds;                    // of the samples
    double area = 0;                  // of all pieces
    int patchCount = 0;               // polygons of a proxy at rate 1 (base_surface.h)
    bool flat = false;                // one normal for all of it
    /// World units of one unit of u and of v: medians by area. None where the texture coordinates have no
    /// area.
    std::optional<Vec2> uvScale;
    /// A twentieth of the area bends outwards with a smaller radius: a relief carved deeper crosses itself
    /// there. Infinite where less of it does.
    double tightRadius = kInfinity;

    /// Half the diagonal of the bounds.
    double radius() const { return 0.5 * bounds.diagonal(); }
};

/// `mesh` must have uvs and pass checkControlMesh. Throws InputError for topology OpenSubdiv refuses
/// (limit_check.h).
SurfaceSurvey surveySurface(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
