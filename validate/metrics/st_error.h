// Texture coordinate error: the distance in texels between the points of the map that the two frames show.
//
// Domain: pixels that both frames cover with the same object of the selection, where both st are finite. Per
// pixel
//     e = | ((s_test - s_reference) * map width, (t_test - t_reference) * map height) |          unit: texels
// Along an axis on which the map repeats, the difference is taken modulo one tile, in [-1/2, 1/2] tiles,
// because st is unwrapped but jumps at the seam of a closed surface. An error of more than half a tile along
// such an axis is therefore underestimated: whole tiles, which look the same, aren't counted. Along a clamped
// axis the difference isn't wrapped.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct StError {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0; // shared, but an st is NaN or infinite
    Figure meanTexels, p95Texels;
};

/// Absent if a frame lacks st.S or st.T, or an object of the selection has no map of known size.
StError computeStError(const FramePair& pair, ObjectSelection selection);

Metric stErrorMetric();

} // namespace plumbline
