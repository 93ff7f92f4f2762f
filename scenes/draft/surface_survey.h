// Measurements of an unknown surface for which a scene is drafted: position, orientation, texture scale and
// curvature. Measured on samples of the limit surface, each of which represents a piece of its area. Space:
// that of the given mesh.
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
    bool flat = false;                // the same normal everywhere
    /// World units per unit of u and of v, as area-weighted medians. Nothing if the texture coordinates have
    /// no area.
    std::optional<Vec2> uvScale;
    /// On 5 % of the area, the surface is convex with a smaller radius of curvature; a relief carved deeper
    /// self-intersects there. Infinite if less than 5 % of the area is convex.
    double tightRadius = kInfinity;

    /// Half the diagonal of the bounds.
    double radius() const { return 0.5 * bounds.diagonal(); }
};

/// `mesh` must have uvs and pass checkControlMesh. Throws InputError for topology that OpenSubdiv rejects
/// (limit_check.h).
SurfaceSurvey surveySurface(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
