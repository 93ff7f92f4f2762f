// What a reference says of its own error.
#pragma once

#include <string>

namespace plumbline {

/// How far the traced micro-triangles are from the surface P(u,v) they stand for, measured.
///
/// Each pixel that shows the surface has the bound of the grid of 16 x 16 micro-cells it sees
/// (MicroGrid::errorWorld): no place of the surface is farther from the one of the same (u,v) on the
/// micro-triangles. The relief's part of it comes from the texels themselves (points inside, edges, creases),
/// the base's from samples, with a margin. Percentiles are nearest-rank over those pixels; 0 without any.
struct Certificate {
    double worldP50 = 0, worldP99 = 0, worldMax = 0; // world units
    double pxP50 = 0, pxP99 = 0, pxMax = 0; // pixels: seen from the camera, as if across the line of sight
    double aimPx = 0;                       // what pxP99 was to be
    std::string limit; // why pxP99 is above the aim ("--memory 256 MB"); empty if it isn't
};

} // namespace plumbline
