// Bakes a pyramid of the minimum and maximum relief depth of blocks of the bilinear surface.
//
// Level 0 has a cell for each bilinear patch: (i, j) lies between the centers of texels (i, j) and (i + 1, j
// + 1). The extrema of a bilinear patch are at its corners, so the bounds are values of the map and exact.
#include "realtime/bake/bake_kinds.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace plumbline {
namespace {

using Level = BakedMap::Level;

constexpr int kRowsATask = 16;
constexpr size_t kBoundsACell = 2;

struct DepthBounds {
    float least = 1, most = 0;
    void add(float low, float high) {
        least = std::min(least, low);
        most = std::max(most, high);
    }
};

/// Creates a level with the values bounds(i, j).
template <class Bounds>
Level makeLevel(int width, int height, const Bounds& bounds) {
    Level level{width, height, {}};
    level.values.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * kBoundsACell);
    tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsATask), [&](const auto& rows) {
        float* value =
            &level.values[static_cast<size_t>(rows.begin()) * static_cast<size_t>(width) * kBoundsACell];
        for (int j = rows.begin(); j < rows.end(); ++j)
            for (int i = 0; i < width; ++i) {
                const DepthBounds cell = bounds(i, j);
                *value++ = cell.least;
                *value++ = cell.most;
            }
    });
    return level;
}

Level boundsOfPatches(const HeightMap& map) {
    return makeLevel(map.width(), map.height(), [&](int i, int j) {
        DepthBounds bounds;
        for (const int row : {j, j + 1})
            for (const int column : {i, i + 1}) {
                const float depth = map.texel(column, row);
                bounds.add(depth, depth);
            }
        return bounds;
    });
}

/// The end of block `index` of `count` among the finer level's cells; the last block includes a remaining
/// cell.
int blockEnd(int index, int count, int cells) {
    return index + 1 == count ? cells : 2 * (index + 1);
}

Level boundsOfBlocks(const Level& finer) {
    const int width = std::max(1, finer.width / 2), height = std::max(1, finer.height / 2);
    return makeLevel(width, height, [&](int i, int j) {
        DepthBounds bounds;
        for (int row = 2 * j; row < blockEnd(j, height, finer.height); ++row)
            for (int column = 2 * i; column < blockEnd(i, width, finer.width); ++column) {
                const float* cell =
                    &finer.values[(static_cast<size_t>(row) * static_cast<size_t>(finer.width) +
                                   static_cast<size_t>(column)) *
                                  kBoundsACell];
                bounds.add(cell[0], cell[1]);
            }
        return bounds;
    });
}

} // namespace

BakedMap bakeMaxMipmap(const HeightMap& map, const BakeRequest&) {
    constexpr double kAllLevels = 2; // all levels together have fewer cells than two of the finest
    requireMemory(fmt::format("the pyramid of {}", map.name()),
                  kAllLevels * map.width() * map.height() * kBoundsACell * sizeof(float));
    BakedMap baked;
    baked.channels = kBoundsACell;
    baked.levels.push_back(boundsOfPatches(map));
    while (baked.levels.back().width > 1 || baked.levels.back().height > 1)
        baked.levels.push_back(boundsOfBlocks(baked.levels.back()));
    return baked;
}

} // namespace plumbline
