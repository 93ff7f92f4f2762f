#include "realtime/technique/baked_family.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {

const std::vector<BakedFamily>& bakedFamilies() {
    // Units 0 and 1 are used by the height map and the color map.
    static const std::vector<BakedFamily> families{
        {"cone_map.glsl",
         "uConeMap",
         nullptr,
         2,
         false,
         {"cone_step", "cone_step_quad", "cone_step_relaxed", "cone_step_relaxed_2007"}},
        {"normal_map.glsl", "uNormalMap", "uNormalMapScale", 3, false, {"normal"}},
        {"distance_field.glsl", "uDistanceField", nullptr, 4, false, {"distance_field"}},
        {"depth_bounds.glsl", "uDepthBounds", nullptr, 5, true, {"max_mipmap"}},
    };
    return families;
}

int unitBehindBaked() {
    int last = 0;
    for (const BakedFamily& family : bakedFamilies())
        last = std::max(last, family.unit);
    return last + 1;
}

const BakedFamily& bakedFamily(const std::string& kind) {
    for (const BakedFamily& family : bakedFamilies())
        if (std::find(family.kinds.begin(), family.kinds.end(), kind) != family.kinds.end()) return family;
    throw InputError("input", fmt::format("'{}' is not a kind of baked map", kind));
}

} // namespace plumbline
