#include "scenes/maps/color_map.h"

#include "scenes/core/index.h"
#include "scenes/maps/bilinear.h"

#include <cmath>
#include <limits>

namespace plumbline {

Vec3 ColorMap::sample(const Vec2& st) const {
    if (!std::isfinite(st.x) || !std::isfinite(st.y)) return Vec3(std::numeric_limits<double>::quiet_NaN());
    const TexelPair s = texelPair(st.x, width, Wrap::Repeat);
    const TexelPair t = texelPair(st.y, height, Wrap::Repeat);
    const auto color = [&](int i, int j) {
        const size_t texel = indexIn(width, i, j);
        return Vec3(rgb[3 * texel], rgb[3 * texel + 1], rgb[3 * texel + 2]);
    };
    const Vec3 lower = glm::mix(color(s.first, t.first), color(s.second, t.first), s.weight);
    const Vec3 upper = glm::mix(color(s.first, t.second), color(s.second, t.second), s.weight);
    return glm::mix(lower, upper, t.weight);
}

} // namespace plumbline
