// Bakes unit normals of the relief at texel centers, together with its depth.
//
// Frame: (along s, along t, out of the surface). The relief z = -depth(s, t) has the normal (D_s sz/sx, D_t
// sz/sy, 1) / length, D_s and D_t per map width and height (notation of realtime/README.md). They are central
// differences of the neighboring texels, that is, the mean of the slopes of the bilinear patches on both
// sides. Beyond a clamped border the relief is flat, so the slope at the border is half of the inner slope.
#include "realtime/bake/bake_kinds.h"
#include "realtime/bake/scale_ratios.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace plumbline {
namespace {

constexpr int kRowsATask = 16;
constexpr int kChannels = 4;

/// Relief depth per texel.
Vec2 centralDifference(const HeightMap& map, int i, int j) {
    const auto depth = [&](int column, int row) { return static_cast<double>(map.texel(column, row)); };
    return {(depth(i + 1, j) - depth(i - 1, j)) / 2, (depth(i, j + 1) - depth(i, j - 1)) / 2};
}

} // namespace

BakedMap bakeNormalMap(const HeightMap& map, const BakeRequest& request) {
    const int width = map.width(), height = map.height();
    const ScaleRatios ratios = scaleRatios(request.scale);
    const Vec2 slopePerDifference(width * ratios.perWidth, height * ratios.perHeight);
    const size_t rowValues = static_cast<size_t>(width) * kChannels;
    requireMemory(fmt::format("the normal map of {}", map.name()),
                  static_cast<double>(rowValues) * height * sizeof(float));

    BakedMap baked;
    baked.channels = kChannels;
    baked.levels.push_back({width, height, std::vector<float>(rowValues * static_cast<size_t>(height))});
    std::vector<float>& values = baked.levels[0].values;
    tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsATask), [&](const auto& rows) {
        float* value = &values[static_cast<size_t>(rows.begin()) * rowValues];
        for (int j = rows.begin(); j < rows.end(); ++j)
            for (int i = 0; i < width; ++i) {
                const Vec3 normal =
                    glm::normalize(Vec3(centralDifference(map, i, j) * slopePerDifference, 1.0));
                for (const double component : {normal.x, normal.y, normal.z})
                    *value++ = static_cast<float>(component);
                *value++ = map.texel(i, j);
            }
    });
    return baked;
}

} // namespace plumbline
