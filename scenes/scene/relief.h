// The relief that displaces a surface (the complete formula is in displaced_surface.h).
#pragma once

#include "scenes/core/math.h"
#include "scenes/maps/height_map.h"

#include <memory>
#include <optional>

namespace plumbline {

/// The faces of an edge may displace it differently where texture coordinates are discontinuous or a crease
/// has two normals. Weld: both use the mean, so that the surface stays closed. Open: each face keeps its own
/// displacement, which leaves a gap.
enum class Seams { Weld, Open };

/// P = S + k * (offset - depth * d(st)), st = tile * uv + uvOffset, where k is the surface's unit normal
/// n(u,v) or a constant axis.
struct Relief {
    std::shared_ptr<const HeightMap> map; // never null; `constant` in the file becomes a 1x1 map
    double depth = 0;                     // world units, >= 0
    double offset = 0;                    // world units
    Vec2 tile{1, 1};
    Vec2 uvOffset{0, 0};
    Seams seams = Seams::Weld;
    std::optional<Vec3> axisWorld{}; // k, unit; if none, k is the normal
};

} // namespace plumbline
