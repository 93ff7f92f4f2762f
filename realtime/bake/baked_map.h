// A map precomputed from a height map: cone ratios, distances, normals or depth bounds.
//
// Texture space: s, t in map widths and heights, row 0 = bottom, like the height map; relief depth d, 0 on
// top and 1 deepest.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plumbline {

struct BakedMap {
    /// One mip level: slices x height x width x channels values, row 0 of each slice = bottom, channels
    /// innermost.
    struct Level {
        int width = 0, height = 0;
        std::vector<float> values;
    };

    std::string kind; // name in bakeKinds()
    int slices = 1;   // meaning: BakeKind::slices
    int channels = 1; // 1 to 4
    std::vector<Level>
        levels; // at least one; each side of level k + 1 has max(1, n / 2) texels, n that of level k

    /// First channel of a texel.
    const float* at(int level, int slice, int column, int row) const {
        const Level& l = levels[static_cast<size_t>(level)];
        const size_t texel =
            (static_cast<size_t>(slice) * static_cast<size_t>(l.height) + static_cast<size_t>(row)) *
                static_cast<size_t>(l.width) +
            static_cast<size_t>(column);
        return &l.values[texel * static_cast<size_t>(channels)];
    }
    size_t bytes() const {
        size_t count = 0;
        for (const Level& level : levels)
            count += level.values.size();
        return count * sizeof(float);
    }
};

} // namespace plumbline
