// Deviation of a height map from the plane through three of its points.
#pragma once

#include "scenes/maps/height_map.h"

#include <array>

namespace plumbline {

/// Texel coordinates of st. Texel centers, where creases between bilinear patches cross, have integer
/// coordinates.
inline Vec2 texelCoordinates(const HeightMap& map, const Vec2& st) {
    return {st.x * map.width() - 0.5, st.y * map.height() - 0.5};
}

/// A point of the map: texel coordinates and depth d.
struct MapPoint {
    Vec2 texel;
    double depth;
};

/// The maximum of |d - linear interpolation of the corners| over a triangle in texel space, in units of
/// depth. Exact, except for triangles over more than 64 texels, for which it is the map's range. The
/// difference of a bilinear patch and a plane is a saddle without an interior extremum, so the maximum over
/// the triangle is at a texel center inside it, or on an edge, at a crease or between two creases.
double triangleDeviation(const HeightMap& map, const std::array<MapPoint, 3>& corners);

/// The same over the triangles a b c and d c b of a micro-cell. If the result is at most `enough`, any number
/// up to `enough` may be returned: for most cells, their gradients already show that they aren't the worst of
/// their grid.
double cellDeviation(const HeightMap& map, const MapPoint& a, const MapPoint& b, const MapPoint& c,
                     const MapPoint& d, double enough = 0);

} // namespace plumbline
