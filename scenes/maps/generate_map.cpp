#include "scenes/maps/generate_map.h"

#include "scenes/core/error.h"
#include "scenes/maps/generate_stone.h"
#include "scenes/maps/map_texels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline {

namespace {

// The use of a random number; different purposes have independent numbers.
enum Purpose : uint32_t { kBrickTop = 100, kPinWidth, kFinWidth, kWavePhase };

/// Tile coordinate of the center of texel i.
double center(int i, int size) {
    return (i + 0.5) / size;
}

double fraction(double x) {
    return x - std::floor(x);
}

std::vector<float> brickTexels(int size, unsigned seed) {
    constexpr int kColumns = 4, kRows = 8; // an even number of rows, so that the running bond tiles
    constexpr double kMortar = 0.012,
                     kBevel = 0.018;   // tile units: half the joint, and its sloped edge
    constexpr double kLowestTop = 0.3; // depth
    return fillTexels(size, [=](int i, int j) {
        const double t = center(j, size) * kRows;
        const int row = static_cast<int>(t);
        const double s = fraction(center(i, size) + (row % 2 ? 0.5 / kColumns : 0.0)) * kColumns;
        const int column = static_cast<int>(s);
        const double x = fraction(s), y = fraction(t);
        const double toEdge = std::min(std::min(x, 1 - x) / kColumns, std::min(y, 1 - y) / kRows);
        const double top = kLowestTop * randomAt(seed, kBrickTop, column, row);
        return std::max(top, 1 - std::max(0.0, toEdge - kMortar) / kBevel);
    });
}

std::vector<float> pyramidTexels(int size, unsigned) {
    constexpr int kCells = 8;
    return fillTexels(size, [=](int i, int j) {
        const double x = fraction(center(i, size) * kCells), y = fraction(center(j, size) * kCells);
        return 2 * std::max(std::abs(x - 0.5), std::abs(y - 0.5));
    });
}

/// Divides a side of any size into cells of about 16 texels, so that thin features have space between them.
struct TexelCells {
    int size, count;
    explicit TexelCells(int texels) : size(texels), count(std::max(1, texels / 16)) {}
    int start(int cell) const { return static_cast<int>(int64_t(cell) * size / count); }
    int of(int texel) const {
        const int cell = static_cast<int>(int64_t(texel) * count / size);
        return cell + 1 < count && start(cell + 1) <= texel ? cell + 1 : cell;
    }
    /// Is the texel among the middle `width` of its cell?
    bool inMiddle(int texel, int width) const {
        const int cell = of(texel), first = start(cell), room = start(cell + 1) - first;
        const int begin = first + std::max(0, (room - width) / 2);
        return texel >= begin && texel < begin + width;
    }
};

int widthInTexels(double random) {
    return 1 + static_cast<int>(4 * random);
}

std::vector<float> pinTexels(int size, unsigned seed) {
    const TexelCells cells(size);
    return fillTexels(size, [&](int i, int j) {
        const int width = widthInTexels(randomAt(seed, kPinWidth, cells.of(i), cells.of(j)));
        return cells.inMiddle(i, width) && cells.inMiddle(j, width) ? 0.0 : 1.0;
    });
}

std::vector<float> finTexels(int size, unsigned seed) {
    const TexelCells cells(size);
    return fillTexels(size, [&](int i, int) {
        return cells.inMiddle(i, widthInTexels(randomAt(seed, kFinWidth, cells.of(i)))) ? 0.0 : 1.0;
    });
}

std::vector<float> waveTexels(int size, unsigned seed) {
    const auto phase = [&](int wave) { return seed == 0 ? 0.0 : randomAt(seed, kWavePhase, wave); };
    const double a = phase(0), b = phase(1), c = phase(2);
    return fillTexels(size, [=](int i, int j) {
        const double s = center(i, size), t = center(j, size);
        return 0.5 - (0.25 * sineOfTurns(2 * s + t + a) + 0.15 * sineOfTurns(3 * t - s + b) +
                      0.1 * sineOfTurns(4 * s - 3 * t + c));
    });
}

std::vector<float> rampTexels(int size, unsigned) {
    return fillTexels(size, [=](int i, int) { return 1 - std::abs(2 * center(i, size) - 1); });
}

struct Kind {
    std::string_view name;
    std::vector<float> (*texels)(int size, unsigned seed);
};
constexpr std::array<Kind, 8> kKinds{{{"cobbles", cobbleTexels},
                                      {"bricks", brickTexels},
                                      {"pyramids", pyramidTexels},
                                      {"pins", pinTexels},
                                      {"fins", finTexels},
                                      {"waves", waveTexels},
                                      {"ramp", rampTexels},
                                      {"noise", noiseTexels}}};

} // namespace

const std::vector<std::string>& generatedMapKinds() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        for (const Kind& kind : kKinds)
            result.emplace_back(kind.name);
        return result;
    }();
    return names;
}

HeightMap generateMap(const std::string& kind, int size, unsigned seed, Wrap wrapS, Wrap wrapT) {
    const auto found = std::ranges::find(kKinds, kind, &Kind::name);
    if (found == kKinds.end())
        throw InputError("generate", fmt::format("kind '{}' is unknown", kind), listOf(generatedMapKinds()),
                         didYouMean(kind, generatedMapKinds()));
    if (size < 1 || size > kMaxGeneratedTexels)
        throw InputError(fmt::format("generate '{}'", kind), fmt::format("size = {}", size),
                         fmt::format("a whole number from 1 to {}", kMaxGeneratedTexels));
    return HeightMap(fmt::format("generated {}, {} x {}, seed {}", kind, size, size, seed), size, size,
                     found->texels(size, seed), wrapS, wrapT);
}

} // namespace plumbline
