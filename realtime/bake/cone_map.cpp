#include "realtime/bake/cone_map.h"

#include "realtime/bake/bake_kinds.h"
#include "realtime/bake/cone_near.h"
#include "realtime/bake/cone_search.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

constexpr ConeRule kConservative{1, false, 0}, kQuad{4, false, 0}, kSafe{1, true, 0}, k2007{1, true, 1};

/// Null for other kinds of maps.
const ConeRule* findRule(std::string_view kind) {
    if (kind == "cone_step") return &kConservative;
    if (kind == "cone_step_quad") return &kQuad;
    if (kind == "cone_step_relaxed") return &kSafe;
    if (kind == "cone_step_relaxed_2007") return &k2007;
    return nullptr;
}

size_t texelIndex(const HeightMap& map, int column, int row) {
    return static_cast<size_t>(row) * static_cast<size_t>(map.width()) + static_cast<size_t>(column);
}

int sectorOf(const ConeRule& rule, int channel) {
    return rule.sectors == 1 ? kAllDirections : channel;
}

/// Rounded squared slopes (keptSlopeSquared) of every texel and sector, channels innermost.
std::vector<float> searchTexels(const ConePairs& pairs) {
    const HeightMap& map = pairs.map();
    const DepthPyramid pyramid(pairs);
    const ConeSearch search(pairs, pyramid);
    const int sectors = pairs.rule().sectors;
    std::vector<float> slopes(map.depths().size() * static_cast<size_t>(sectors));
    tbb::parallel_for(0, map.height(), [&](int row) {
        std::array<ConeSearch::Winner, 4> winners;
        for (int column = 0; column < map.width(); ++column)
            for (int channel = 0; channel < sectors; ++channel)
                slopes[texelIndex(map, column, row) * static_cast<size_t>(sectors) +
                       static_cast<size_t>(channel)] =
                    search.steepestSquared(column, row, sectorOf(pairs.rule(), channel),
                                           winners[static_cast<size_t>(channel)]);
    });
    return slopes;
}

void fillTexels(const HeightMap& map, const ConeRule& rule, float* ratios) {
    const std::vector<float> slopes = searchTexels(ConePairs(map, ConeSlice::Texels, rule));
    std::transform(slopes.begin(), slopes.end(), ratios, coneRatio);
}

/// Rounded squared slope of a cell: the maximum of the far pairs of its corners and of nearSlope.
float cellSlope(const HeightMap& map, const ConeRule& rule, const std::vector<float>& farSlopes, int column,
                int row, int channel) {
    const auto next = [](int i, int size, Wrap wrap) {
        return i + 1 < size ? i + 1 : wrap == Wrap::Repeat ? 0 : i;
    };
    const int right = next(column, map.width(), map.wrapS()), above = next(row, map.height(), map.wrapT());
    const auto corner = [&](int i, int j) {
        return farSlopes[texelIndex(map, i, j) * static_cast<size_t>(rule.sectors) +
                         static_cast<size_t>(channel)];
    };
    const float far = std::max(std::max(corner(column, row), corner(right, row)),
                               std::max(corner(column, above), corner(right, above)));
    const double farSlope = std::sqrt(static_cast<double>(far));
    const double near = nearSlope(map, rule, column, row, sectorOf(rule, channel), farSlope);
    return near > farSlope ? std::max(far, keptSlopeSquared(near * near)) : far;
}

/// Whether the cell also covers points outside the map.
bool holdsOutside(const HeightMap& map, int column, int row) {
    const auto onBorder = [](int i, int size, Wrap wrap) {
        return wrap == Wrap::Clamp && (i == 0 || i + 1 == size);
    };
    return onBorder(column, map.width(), map.wrapS()) || onBorder(row, map.height(), map.wrapT());
}

void fillCells(const HeightMap& map, const ConeRule& rule, float* ratios) {
    const std::vector<float> farSlopes = searchTexels(ConePairs(map, ConeSlice::Cells, rule));
    const auto sectors = static_cast<size_t>(rule.sectors);
    tbb::parallel_for(0, map.height(), [&](int row) {
        for (int column = 0; column < map.width(); ++column) {
            float* cell = ratios + texelIndex(map, column, row) * sectors;
            for (size_t channel = 0; channel < sectors; ++channel)
                cell[channel] =
                    coneRatio(cellSlope(map, rule, farSlopes, column, row, static_cast<int>(channel)));
            if (holdsOutside(map, column, row))
                std::fill_n(cell, sectors, *std::min_element(cell, cell + sectors));
        }
    });
}

/// First and last texel of the finer level, along one axis.
std::pair<int, int> finerTexels(int i, int size, int finerSize) {
    return {std::min(2 * i, finerSize - 1), i + 1 == size ? finerSize - 1 : 2 * i + 1};
}

BakedMap::Level coarser(const BakedMap::Level& finer, int slices, int channels) {
    BakedMap::Level level{std::max(1, finer.width / 2), std::max(1, finer.height / 2), {}};
    const auto at = [&](const BakedMap::Level& l, int slice, int row, int column, int channel) {
        return static_cast<size_t>(
            ((static_cast<int64_t>(slice) * l.height + row) * l.width + column) * channels + channel);
    };
    level.values.resize(at(level, slices, 0, 0, 0));
    for (int slice = 0; slice < slices; ++slice)
        for (int row = 0; row < level.height; ++row)
            for (int column = 0; column < level.width; ++column)
                for (int channel = 0; channel < channels; ++channel) {
                    const auto [bottom, top] = finerTexels(row, level.height, finer.height);
                    const auto [left, right] = finerTexels(column, level.width, finer.width);
                    float least = kInfinityF;
                    for (int j = bottom; j <= top; ++j)
                        for (int i = left; i <= right; ++i)
                            least = std::min(least, finer.values[at(finer, slice, j, i, channel)]);
                    level.values[at(level, slice, row, column, channel)] = least;
                }
    return level;
}

void requireConeMemory(const HeightMap& map, const ConeRule& rule) {
    const auto texels = static_cast<double>(map.depths().size());
    const double kept = double(sizeof(float)) * rule.sectors;
    const double working = DepthPyramid::bytesPerTexel(rule) + kept;
    requireMemory("cone map of " + map.name(), texels * (2 * kept * 4 / 3 + working));
}

} // namespace

BakedMap makeConeMap(const HeightMap& map, const ConeRule& rule) {
    requireConeMemory(map, rule);
    BakedMap cones;
    cones.slices = 2;
    cones.channels = rule.sectors;
    const size_t sliceValues = map.depths().size() * static_cast<size_t>(rule.sectors);
    cones.levels.push_back({map.width(), map.height(), std::vector<float>(2 * sliceValues)});
    float* ratios = cones.levels[0].values.data();
    fillTexels(map, rule, ratios);
    fillCells(map, rule, ratios + sliceValues);
    while (cones.levels.back().width > 1 || cones.levels.back().height > 1)
        cones.levels.push_back(coarser(cones.levels.back(), cones.slices, cones.channels));
    return cones;
}

bool isConeKind(std::string_view kind) {
    return findRule(kind) != nullptr;
}

ConeRule coneRule(std::string_view kind) {
    if (const ConeRule* rule = findRule(kind)) return *rule;
    throw InputError("cone map", "'" + std::string(kind) + "' is not a kind of cone map",
                     "cone_step, cone_step_quad, cone_step_relaxed or cone_step_relaxed_2007");
}

BakedMap bakeConeMap(const HeightMap& map, const BakeRequest&) {
    return makeConeMap(map, kConservative);
}
BakedMap bakeQuadConeMap(const HeightMap& map, const BakeRequest&) {
    return makeConeMap(map, kQuad);
}
BakedMap bakeRelaxedConeMap(const HeightMap& map, const BakeRequest&) {
    return makeConeMap(map, kSafe);
}
BakedMap bakeRelaxedConeMap2007(const HeightMap& map, const BakeRequest&) {
    return makeConeMap(map, k2007);
}

} // namespace plumbline
