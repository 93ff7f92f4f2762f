#include "scenes/maps/generate_stone.h"

#include "scenes/maps/map_texels.h"

#include <algorithm>
#include <array>

namespace plumbline {

namespace {

enum Purpose : uint32_t { kSiteX = 200, kSiteY, kStoneTop, kGradient }; // kGradient + octave are the last

int wrapped(int i, int count) {
    const int rest = i % count;
    return rest < 0 ? rest + count : rest;
}

/// Gradient noise of one tile (Perlin, An Image Synthesizer, 1985; fade of Improving Noise, 2002): a unit
/// gradient at each place of a periodic lattice of cells x cells.
class GradientNoise {
  public:
    GradientNoise(int cells, unsigned seed, uint32_t purpose) : cells_(cells) {
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const double turns = randomAt(seed, purpose, i, j);
                gradients_.push_back({sineOfTurns(turns + 0.25), sineOfTurns(turns)});
            }
    }
    /// Near [-0.7, 0.7].
    double at(double s, double t) const {
        const double x = s * cells_, y = t * cells_;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const double fx = x - i, fy = y - j, u = fade(fx), v = fade(fy);
        const double low = mix(dot(i, j, fx, fy), dot(i + 1, j, fx - 1, fy), u);
        const double high = mix(dot(i, j + 1, fx, fy - 1), dot(i + 1, j + 1, fx - 1, fy - 1), u);
        return mix(low, high, v);
    }

  private:
    static double fade(double x) { return x * x * x * (x * (x * 6 - 15) + 10); }
    static double mix(double a, double b, double weight) { return a + (b - a) * weight; }
    double dot(int i, int j, double x, double y) const { // 0 <= i, j <= cells
        const int column = i == cells_ ? 0 : i, row = j == cells_ ? 0 : j;
        const auto& g = gradients_[indexIn(cells_, column, row)];
        return g[0] * x + g[1] * y;
    }

    int cells_;
    std::vector<std::array<double, 2>> gradients_;
};

/// Octaves of GradientNoise, doubling in frequency and halving in amplitude, as long as a cell spans at least
/// two texels.
class FractalNoise {
  public:
    FractalNoise(int firstCells, int octaves, int size, unsigned seed) {
        for (int octave = 0, cells = firstCells; octave < octaves; ++octave, cells *= 2)
            if (octave == 0 || 2 * cells <= size)
                octaves_.emplace_back(cells, seed, kGradient + static_cast<uint32_t>(octave));
    }
    double at(double s, double t) const {
        double sum = 0, amplitude = 1;
        for (const GradientNoise& octave : octaves_) {
            sum += amplitude * octave.at(s, t);
            amplitude *= 0.5;
        }
        return sum;
    }

  private:
    std::vector<GradientNoise> octaves_;
};

/// Cellular texture (Worley, A Cellular Texture Basis Function, 1996): a site in each cell of a periodic
/// lattice, and the distance of a point to the border of its site's region.
class Stones {
  public:
    static constexpr int kCells = 6;

    explicit Stones(unsigned seed) {
        // Minimum distance of a site to the border of its cell. It keeps the stones similar in size and the
        // nearest sites within the 5 x 5 cells around a point.
        constexpr double kMargin = 0.14;
        for (int j = 0; j < kCells; ++j)
            for (int i = 0; i < kCells; ++i) {
                Site& site = sites_[index(i, j)];
                site.x = kMargin + (1 - 2 * kMargin) * randomAt(seed, kSiteX, i, j);
                site.y = kMargin + (1 - 2 * kMargin) * randomAt(seed, kSiteY, i, j);
                site.top = randomAt(seed, kStoneTop, i, j);
            }
    }

    struct Place {
        double toBorder; // cells; rounded off at the region's corners
        double top;      // of the stone, [0,1), random
    };
    Place at(double s, double t) const {
        const double x = s * kCells, y = t * kCells;
        const int cellX = static_cast<int>(x), cellY = static_cast<int>(y);
        std::array<Neighbor, 25> around;
        size_t nearest = 0, k = 0;
        for (int j = cellY - 2; j <= cellY + 2; ++j)
            for (int i = cellX - 2; i <= cellX + 2; ++i, ++k) {
                const Site& site = sites_[index(i, j)];
                Neighbor& n = around[k];
                n.x = i + site.x;
                n.y = j + site.y;
                n.top = site.top;
                n.squared = (n.x - x) * (n.x - x) + (n.y - y) * (n.y - y);
                if (n.squared < around[nearest].squared) nearest = k;
            }
        return {toBorder(around, nearest), around[nearest].top};
    }

  private:
    struct Site {
        double x, y, top; // x, y within the cell
    };
    struct Neighbor {
        double x, y, top, squared; // squared distance to the point
    };
    static size_t index(int i, int j) { return indexIn(kCells, wrapped(i, kCells), wrapped(j, kCells)); }

    /// Distances e to the bisectors of the nearest site with each other one, (r^2 - r0^2) / (2 |p - p0|),
    /// combined as (sum 1/e^4)^(-1/4): a smooth minimum, rounded off where two are nearly equal.
    static double toBorder(const std::array<Neighbor, 25>& around, size_t nearest) {
        const Neighbor& own = around[nearest];
        double sum = 0;
        for (size_t k = 0; k < around.size(); ++k) {
            if (k == nearest) continue;
            const Neighbor& n = around[k];
            const double between = (n.x - own.x) * (n.x - own.x) + (n.y - own.y) * (n.y - own.y);
            const double gap = n.squared - own.squared;
            if (!(gap > 0)) return 0;                         // on the border
            const double inverse = 4 * between / (gap * gap); // 1/e^2
            sum += inverse * inverse;
        }
        return 1 / std::sqrt(std::sqrt(sum));
    }

    std::array<Site, kCells * kCells> sites_;
};

} // namespace

std::vector<float> cobbleTexels(int size, unsigned seed) {
    constexpr double kJoint = 0.035;      // cells: half the width of the flat joint
    constexpr double kRound = 0.38;       // cells: from the joint to the flat top of a stone
    constexpr double kLowestStone = 0.72; // height of the lowest stone, the highest being 1
    constexpr double kRoughness = 0.05;
    const Stones stones(seed);
    const FractalNoise rough(16, 4, size, seed);
    std::vector<float> texels = fillTexels(size, [&](int i, int j) {
        const double s = (i + 0.5) / size, t = (j + 0.5) / size;
        const Stones::Place place = stones.at(s, t);
        const double x = std::clamp((place.toBorder - kJoint) / kRound, 0.0, 1.0);
        const double rounded = 1 - (1 - x) * (1 - x) * (1 - x); // steep at the joint, but not a wall
        const double height = rounded * (kLowestStone + (1 - kLowestStone) * place.top);
        return 0.9 * (1 - height) + 0.05 + kRoughness * rough.at(s, t);
    });
    stretchToFullRange(texels);
    return texels;
}

std::vector<float> noiseTexels(int size, unsigned seed) {
    const FractalNoise noise(4, 6, size, seed);
    // The sum stays within 0.7 (1 + 1/2 + 1/4 + ...) < 1.4 to either side.
    std::vector<float> texels = fillTexels(
        size, [&](int i, int j) { return 0.5 + noise.at((i + 0.5) / size, (j + 0.5) / size) / 2.8; });
    stretchToFullRange(texels);
    return texels;
}

} // namespace plumbline
