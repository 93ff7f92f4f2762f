// What displaces a surface (displaced_surface.h has the formula in full).
#pragma once

#include "scenes/core/math.h"
#include "scenes/maps/height_map.h"

#include <memory>
#include <optional>

namespace plumbline {

/// Faces that meet in an edge may disagree about its displacement, where texture coordinates jump or a crease
/// has two normals. Weld: the mean of both, the surface stays closed. Open: each face keeps its own, the
/// surface gapes.
enum class Seams { Weld, Open };

/// P = S + k * (offset - depth * d(st)), st = tile * uv + uvOffset, k the surface's unit normal n(u,v) or one
/// axis for all of it.
struct Relief {
    std::shared_ptr<const HeightMap> map; // never null; `constant` in the file becomes a 1x1 map
    double depth = 0;                     // world units, >= 0
    double offset = 0;                    // world units
    Vec2 tile{1, 1};
    Vec2 uvOffset{0, 0};
    Seams seams = Seams::Weld;
    std::optional<Vec3> axisWorld{}; // k, unit; none: along the normal
};

} // namespace plumbline
