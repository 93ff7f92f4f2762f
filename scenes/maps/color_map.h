// A color texture, sampled like the relief's height map (conventions: height_map.h).
#pragma once

#include "scenes/core/math.h"

#include <string>
#include <vector>

namespace plumbline {

/// Linear RGB, row 0 = bottom; repeated.
struct ColorMap {
    std::string name;
    int width = 0, height = 0;
    std::vector<float> rgb; // width x height x 3, linear

    /// Bilinear; NaN where st isn't finite.
    Vec3 sample(const Vec2& st) const;
};

} // namespace plumbline
