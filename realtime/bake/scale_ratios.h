// The ratios of a BakeScale, on which bakers depend: uniform scaling doesn't change slopes or distances
// relative to the relief's depth.
#pragma once

#include "realtime/bake/bake.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

namespace plumbline {

/// Relief depth 1 over one map width, and over one map height; a slope D_s of depth per map width is D_s *
/// perWidth in world space.
struct ScaleRatios {
    double perWidth, perHeight;
};

/// Throws InputError for ratios outside [1e-9, 1e9], for which slopes and distances would exceed the range of
/// a float.
inline ScaleRatios scaleRatios(const BakeScale& scale) {
    constexpr double kLargest = 1e9;
    const ScaleRatios ratios{scale.depth / scale.s, scale.depth / scale.t};
    for (const double ratio : {ratios.perWidth, ratios.perHeight})
        if (!(ratio >= 1 / kLargest && ratio <= kLargest))
            throw InputError(
                "scale", fmt::format("a relief {} deep on a tile of {} x {}", scale.depth, scale.s, scale.t),
                "positive numbers at most 1e9 times as large as one another");
    return ratios;
}

} // namespace plumbline
