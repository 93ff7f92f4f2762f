// Small height maps for the tests of baked maps. Depths from a seed, the same on every machine.
#pragma once

#include "scenes/maps/generate_map.h"
#include "scenes/maps/map_texels.h"

#include <algorithm>
#include <string>
#include <vector>

namespace plumbline {

struct TestMap {
    std::string name;
    HeightMap map;
};

/// Independent random depths, some of them 0 and 1.
inline HeightMap randomMap(int width, int height, unsigned seed, Wrap wrapS, Wrap wrapT) {
    std::vector<float> depths;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double x = 1.25 * randomAt(seed, 77, i, j) - 0.125;
            depths.push_back(static_cast<float>(std::clamp(x, 0.0, 1.0)));
        }
    return HeightMap("random", width, height, std::move(depths), wrapS, wrapT);
}

/// Flat at depth 1 except for a few texels at depth 0.
inline HeightMap needleMap(int width, int height, Wrap wrap) {
    std::vector<float> depths(static_cast<size_t>(width) * static_cast<size_t>(height), 1.0f);
    for (size_t i = 3; i < depths.size(); i += 67)
        depths[i] = 0;
    return HeightMap("needles", width, height, std::move(depths), wrap, wrap);
}

/// A smooth low-contrast map with a slope everywhere, so that many pairs have nearly equal slopes.
inline HeightMap smoothMap(int width, int height, Wrap wrapS, Wrap wrapT) {
    std::vector<float> depths;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double s = (i + 0.5) / width, t = (j + 0.5) / height;
            depths.push_back(static_cast<float>(0.5 + 0.3 * sineOfTurns(2 * s + t) * sineOfTurns(t) +
                                                0.15 * sineOfTurns(3 * s - 2 * t)));
        }
    return HeightMap("smooth", width, height, std::move(depths), wrapS, wrapT);
}

inline std::vector<TestMap> smallMaps() {
    std::vector<TestMap> maps;
    const auto add = [&](std::string name, HeightMap map) {
        maps.push_back({std::move(name), std::move(map)});
    };
    const Wrap repeat = Wrap::Repeat, clamp = Wrap::Clamp;
    add("random 13 x 9, repeat", randomMap(13, 9, 1, repeat, repeat));
    add("random 13 x 9, clamp", randomMap(13, 9, 2, clamp, clamp));
    add("random 6 x 21, repeat and clamp", randomMap(6, 21, 3, repeat, clamp));
    add("random 1 x 17, repeat", randomMap(1, 17, 4, repeat, repeat));
    add("random 17 x 1, clamp", randomMap(17, 1, 5, clamp, clamp));
    add("random 2 x 2, repeat", randomMap(2, 2, 6, repeat, repeat));
    add("random 1 x 2, repeat", randomMap(1, 2, 6, repeat, repeat));
    add("one texel", randomMap(1, 1, 7, repeat, repeat));
    add("constant", HeightMap("constant", 7, 5, std::vector<float>(35, 0.25f)));
    add("needles 24 x 20, repeat", needleMap(24, 20, repeat));
    add("needles 24 x 20, clamp", needleMap(24, 20, clamp));
    add("smooth 33 x 24, repeat", smoothMap(33, 24, repeat, repeat));
    add("smooth 16 x 40, clamp", smoothMap(16, 40, clamp, clamp));
    for (const std::string& kind : generatedMapKinds())
        add(kind + " 24", generateMap(kind, 24, 1, repeat, repeat));
    return maps;
}

} // namespace plumbline
