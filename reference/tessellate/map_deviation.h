// How far a height map is from the plane through three of its points.
#pragma once

#include "scenes/maps/height_map.h"

#include <array>

namespace plumbline {

/// Texel coordinates of st: texel centers, where creases between bilinear patches cross, lie at whole
/// numbers.
inline Vec2 texelCoordinates(const HeightMap& map, const Vec2& st) {
    return {st.x * map.width() - 0.5, st.y * map.height() - 0.5};
}

/// A point of the map: texel coordinates and d there.
struct MapPoint {
    Vec2 texel;
    double depth;
};

/// Largest |d - (linear between the corners)| over a triangle in texel space, in units of depth; too large
/// only for triangles over more than 64 texels, whose bound is the map's range. A bilinear patch less a plane
/// is a saddle, which has no extremum inside; so the extremum over the triangle is at a texel center inside
/// it, or on an edge, at a crease or between two.
double triangleDeviation(const HeightMap& map, const std::array<MapPoint, 3>& corners);

/// The same over the triangles a b c and d c b of a micro-cell; or, where that is no more than `enough`, any
/// number up to that: most cells can be told from their gradients not to be the worst of their grid.
double cellDeviation(const HeightMap& map, const MapPoint& a, const MapPoint& b, const MapPoint& c,
                     const MapPoint& d, double enough = 0);

} // namespace plumbline
