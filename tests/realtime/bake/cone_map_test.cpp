#include "realtime/bake/bake.h"
#include "realtime/bake/cone_map.h"
#include "realtime/bake/cone_near.h"
#include "realtime/bake/cone_search.h"
#include "scenes/core/error.h"
#include "tests/realtime/bake/cone_test_maps.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace plumbline {
namespace {

const char* const kKinds[] = {"cone_step", "cone_step_quad", "cone_step_relaxed", "cone_step_relaxed_2007"};

BakedMap bake(const HeightMap& map, const std::string& kind) {
    BakeRequest request;
    request.kind = kind;
    return bakeMap(map, request);
}

/// Whether a texel outside a clamped map must be considered for cells: those that a quadrant's edge may
/// intersect. (Texels entirely inside the quadrant repeat a nearer point on its edge or in the map, whose
/// pairs are considered anyway.) For texel cones, all pairs are considered.
bool looksOutside(const ConePairs& pairs, int i, int j, const Vec2i& offset, int sector) {
    const HeightMap& map = pairs.map();
    const bool outside = (map.wrapS() == Wrap::Clamp && (i < 0 || i >= map.width())) ||
                         (map.wrapT() == Wrap::Clamp && (j < 0 || j >= map.height()));
    if (!outside || pairs.slice() == ConeSlice::Texels) return true;
    if (sector == kAllDirections || pairs.insideSector(offset, sector)) return false;
    const bool beyondSide = sector < 2 ? map.wrapT() == Wrap::Clamp && (j < 0 || j >= map.height())
                                       : map.wrapS() == Wrap::Clamp && (i < 0 || i >= map.width());
    return !beyondSide;
}

/// The definition: every pair within reach, including repeated images and repeated borders. phi may be
/// smaller than the offset by half a texel's diagonal, at most 0.71 tiles, so offsets of up to 1.23 tiles can
/// reach slope 1.
float steepestOfAllPairs(const ConePairs& pairs, int column, int row, int sector) {
    const HeightMap& map = pairs.map();
    const int reachS = map.width() * 5 / 4 + 1, reachT = map.height() * 5 / 4 + 1;
    double steepest = 1;
    for (int j = row - reachT; j <= row + reachT; ++j)
        for (int i = column - reachS; i <= column + reachS; ++i) {
            const double drop = double(map.texel(column, row)) - map.texel(i, j);
            if (!(drop > 0)) continue;
            const Vec2i k(i - column, j - row);
            const double slope = drop * drop / pairs.distanceSquared(k.x, k.y);
            if (slope > steepest && looksOutside(pairs, i, j, k, sector) &&
                pairs.counts(column, row, k.x, k.y, sector))
                steepest = slope;
        }
    return keptSlopeSquared(steepest);
}

int following(int i, int size, Wrap wrap) {
    return wrap == Wrap::Repeat ? (i + 1) % size : std::min(i + 1, size - 1);
}

/// A cell's ratio from all pairs of its corners and from nearSlope (for border cells of a clamped quad map,
/// the minimum of all sectors).
float cellRatio(const ConePairs& pairs, int i, int j, int sector) {
    const HeightMap& map = pairs.map();
    float slope = keptSlopeSquared(std::pow(nearSlope(map, pairs.rule(), i, j, sector, 0), 2));
    for (const int row : {j, following(j, map.height(), map.wrapT())})
        for (const int column : {i, following(i, map.width(), map.wrapS())})
            slope = std::max(slope, steepestOfAllPairs(pairs, column, row, sector));
    return coneRatio(slope);
}

bool onClampedBorder(const HeightMap& map, int i, int j) {
    return (map.wrapS() == Wrap::Clamp && (i == 0 || i == map.width() - 1)) ||
           (map.wrapT() == Wrap::Clamp && (j == 0 || j == map.height() - 1));
}

TEST(ConeMap, EveryRatio_IsMinimumOfAllPairs) {
    for (const char* kind : kKinds)
        for (const TestMap& test : smallMaps()) {
            SCOPED_TRACE(std::string(kind) + ", " + test.name);
            const HeightMap& map = test.map;
            const ConeRule rule = coneRule(kind);
            const BakedMap cones = bake(map, kind);
            ASSERT_EQ(cones.slices, 2);
            ASSERT_EQ(cones.channels, rule.sectors);
            const ConePairs texels(map, ConeSlice::Texels, rule), cells(map, ConeSlice::Cells, rule);
            for (int j = 0; j < map.height(); ++j)
                for (int i = 0; i < map.width(); ++i)
                    for (int channel = 0; channel < rule.sectors; ++channel) {
                        const int sector = rule.sectors == 1 ? kAllDirections : channel;
                        ASSERT_EQ(cones.at(0, kConeTexels, i, j)[channel],
                                  coneRatio(steepestOfAllPairs(texels, i, j, sector)))
                            << "texel " << i << ", " << j << ", channel " << channel;
                        float cell = cellRatio(cells, i, j, sector);
                        if (rule.sectors > 1 && onClampedBorder(map, i, j))
                            for (const int other : {0, 1, 2, 3})
                                cell = std::min(cell, cellRatio(cells, i, j, other));
                        ASSERT_EQ(cones.at(0, kConeCells, i, j)[channel], cell)
                            << "cell " << i << ", " << j << ", channel " << channel;
                    }
        }
}

/// The quadrant of a direction: E, W, N, S.
int quadrant(const Vec2& direction) {
    if (std::abs(direction.x) >= std::abs(direction.y)) return direction.x >= 0 ? 0 : 1;
    return direction.y >= 0 ? 2 : 3;
}

/// The guarantee of slice 1, checked on the surface: random points at all distances, and on creases.
TEST(ConeMap, Cones_ContainNoSurface) {
    constexpr int kPairs = 200000;
    for (const char* kind : {"cone_step", "cone_step_quad"})
        for (const TestMap& test : smallMaps()) {
            SCOPED_TRACE(std::string(kind) + ", " + test.name);
            const HeightMap& map = test.map;
            const BakedMap cones = bake(map, kind);
            const Vec2 size(map.width(), map.height());
            double tightest = 0;
            for (int n = 0; n < kPairs; ++n) {
                const auto draw = [&](uint32_t purpose) { return randomAt(5, purpose, n); };
                const Vec2 x(draw(0), draw(1));
                const double angle = draw(2), reach = std::exp(-7 * draw(3));
                Vec2 y = x + reach * Vec2(sineOfTurns(angle + 0.25), sineOfTurns(angle));
                if (n % 3 == 0) y = (glm::floor(y * size - 0.5) + 0.5) / size; // a texel center
                if (n % 3 == 1) y.x = (std::floor(y.x * size.x) + 0.5) / size.x;
                if (y == x) continue;
                const Vec2i cell = glm::clamp(Vec2i(glm::floor(x * size - 0.5)), Vec2i(-1), Vec2i(size) - 1);
                const auto index = [](int i, int n_, Wrap wrap) {
                    return i >= 0 ? i : wrap == Wrap::Repeat ? n_ - 1 : 0;
                };
                const float c = cones.at(
                    0, kConeCells, index(cell.x, map.width(), map.wrapS()),
                    index(cell.y, map.height(), map.wrapT()))[cones.channels == 1 ? 0 : quadrant(y - x)];
                // Depths are accurate to 1e-16, so a slope over 1e-7 st is accurate to 1e-9.
                const double room = glm::length(y - x) - c * (map.depth(x) - map.depth(y));
                ASSERT_GE(room, -1e-14) << "from " << x.x << ", " << x.y << " to " << y.x << ", " << y.y;
                tightest = std::max(tightest, c * (map.depth(x) - map.depth(y)) / glm::length(y - x));
            }
            RecordProperty(std::string(kind) + ", " + test.name, std::to_string(tightest));
        }
}

/// The lemma for slice 1: phi, interpolated between integer offsets, never exceeds the length outside the
/// squares that touch 0. It isn't much smaller either: at least cos 45 degrees times the length, and within 3
/// % from four texels on.
TEST(ConeMap, Phi_IsBelowDistance) {
    for (const Vec2i size :
         {Vec2i(8, 8), Vec2i(1, 64), Vec2i(16, 40), Vec2i(5, 3), Vec2i(300, 2), Vec2i(1, 1)}) {
        const HeightMap map(
            "flat", size.x, size.y,
            std::vector<float>(static_cast<size_t>(size.x) * static_cast<size_t>(size.y), 0.5f));
        const ConePairs pairs(map, ConeSlice::Cells, {});
        const auto phi = [&](int ks, int kt) { return std::sqrt(pairs.distanceSquared(ks, kt)); };
        for (int n = 0; n < 200000; ++n) {
            const double reach = std::exp(6 * randomAt(1, 2, n));
            const Vec2 delta = reach * (2.0 * Vec2(randomAt(1, 0, n), randomAt(1, 1, n)) - 1.0);
            if (std::max(std::abs(delta.x), std::abs(delta.y)) <= 1) continue;
            const Vec2i k(glm::floor(delta));
            const Vec2 w = delta - Vec2(k);
            const double interpolated = (1 - w.y) * ((1 - w.x) * phi(k.x, k.y) + w.x * phi(k.x + 1, k.y)) +
                                        w.y * ((1 - w.x) * phi(k.x, k.y + 1) + w.x * phi(k.x + 1, k.y + 1));
            const double length = glm::length(delta / Vec2(size));
            ASSERT_LE(interpolated, length)
                << delta.x << ", " << delta.y << " of " << size.x << " x " << size.y;
            ASSERT_GE(phi(k.x, k.y), std::sqrt(0.5) * (1 - 1e-9) * glm::length(Vec2(k) / Vec2(size)));
            if (size.x == size.y && glm::length(Vec2(k)) >= 4) {
                ASSERT_GE(phi(k.x, k.y), 0.97 * glm::length(Vec2(k) / Vec2(size)));
            }
        }
    }
}

/// A wall of depth 0 on a floor of depth 1, at texel 2 of 8: floor texels at distance k have the ratio k / 8;
/// the wall has 1.
TEST(ConeMap, Wall_RatiosAreDistances) {
    const HeightMap map("wall", 8, 1, {1, 1, 0, 1, 1, 1, 1, 1});
    const double distances[] = {2, 1, 8, 1, 2, 3, 4, 3}; // to the nearest image
    for (const char* kind : {"cone_step", "cone_step_relaxed_2007"}) {
        const BakedMap cones = bake(map, kind);
        for (int i = 0; i < 8; ++i) {
            EXPECT_LE(*cones.at(0, kConeTexels, i, 0), distances[i] / 8);
            EXPECT_NEAR(*cones.at(0, kConeTexels, i, 0), distances[i] / 8, 2e-7);
        }
    }
    const BakedMap quad = bake(map, "cone_step_quad");
    EXPECT_NEAR(quad.at(0, kConeTexels, 4, 0)[0], 6.0 / 8, 2e-7); // +s: the next image of the wall
    EXPECT_NEAR(quad.at(0, kConeTexels, 4, 0)[1], 2.0 / 8, 2e-7);
    EXPECT_EQ(quad.at(0, kConeTexels, 4, 0)[2], 1);
}

TEST(ConeMap, Levels_HoldBlockMinimum) {
    const BakedMap cones = bake(randomMap(13, 6, 3, Wrap::Repeat, Wrap::Repeat), "cone_step_quad");
    ASSERT_EQ(cones.levels.size(), 4u); // 13 x 6, 6 x 3, 3 x 1, 1 x 1
    for (size_t level = 1; level < cones.levels.size(); ++level) {
        const BakedMap::Level &fine = cones.levels[level - 1], &coarse = cones.levels[level];
        EXPECT_EQ(coarse.width, std::max(1, fine.width / 2));
        EXPECT_EQ(coarse.height, std::max(1, fine.height / 2));
        for (int slice = 0; slice < 2; ++slice)
            for (int channel = 0; channel < 4; ++channel) {
                std::vector<float> least(static_cast<size_t>(coarse.width * coarse.height), kInfinityF);
                for (int j = 0; j < fine.height; ++j)
                    for (int i = 0; i < fine.width; ++i) {
                        float& block =
                            least[static_cast<size_t>(std::min(j / 2, coarse.height - 1) * coarse.width +
                                                      std::min(i / 2, coarse.width - 1))];
                        block = std::min(block, cones.at(int(level) - 1, slice, i, j)[channel]);
                    }
                for (int j = 0; j < coarse.height; ++j)
                    for (int i = 0; i < coarse.width; ++i)
                        EXPECT_EQ(cones.at(int(level), slice, i, j)[channel],
                                  least[static_cast<size_t>(j * coarse.width + i)]);
            }
    }
}

TEST(ConeMap, RelaxedCones_AreAtLeastAsWide) {
    for (const TestMap& test : smallMaps()) {
        const BakedMap narrow = bake(test.map, "cone_step"), wide = bake(test.map, "cone_step_relaxed"),
                       wider = bake(test.map, "cone_step_relaxed_2007");
        for (size_t i = 0; i < narrow.levels[0].values.size(); ++i) {
            ASSERT_LE(narrow.levels[0].values[i], wide.levels[0].values[i]) << test.name;
            ASSERT_LE(wide.levels[0].values[i], wider.levels[0].values[i]) << test.name;
        }
    }
}

/// Listing 18-2 with its errata corrected (an exit is the first sample outside after one inside; steps of
/// 1/32 of a texel): from depth 0 above p through each texel center q until the ray exits. The exit is
/// between the last sample inside and the first one outside, which gives two ratios.
struct MarchedRatio {
    double least = 1, most = 1;
};
MarchedRatio ratioByMarching(const HeightMap& map, int column, int row) {
    constexpr double kStepsATexel = 32;
    const Vec2 size(map.width(), map.height());
    const Vec2 start = (Vec2(column, row) + 0.5) / size;
    const double depth = map.texel(column, row);
    MarchedRatio ratio;
    for (int j = row - map.height(); j <= row + map.height(); ++j)
        for (int i = column - map.width(); i <= column + map.width(); ++i) {
            const Vec2 offset = Vec2(i - column, j - row) / size;
            const double through = map.texel(i, j), length = glm::length(offset);
            if (length == 0 || length >= 1 || through >= depth) continue;
            const double step = 1 / (std::max(std::abs(i - column), std::abs(j - row)) * kStepsATexel);
            double inside = 1;
            for (double at = 1 + step; at * through < depth && at * length < 1; at += step) {
                if (map.depth(start + at * offset) > at * through) {
                    ratio.least = std::min(ratio.least, inside * length / (depth - inside * through));
                    ratio.most = std::min(ratio.most, at * length / (depth - at * through));
                    break;
                }
                inside = at;
            }
        }
    return ratio;
}

/// The marched exits include those at texel centers that the criterion finds, and others between adjacent
/// texels. So individual ratios may differ, mostly by less than two texels, and their means agree within the
/// marching step.
TEST(ConeMap, Criterion2007_EqualsListingsMarch) {
    constexpr int kSize = 32;
    for (const char* kind : {"cobbles", "waves", "pyramids", "noise"}) {
        const HeightMap map = generateMap(kind, kSize, 1, Wrap::Repeat, Wrap::Repeat);
        const BakedMap cones = bake(map, "cone_step_relaxed_2007");
        double sumLeast = 0, sumMost = 0, sum = 0;
        int farOff = 0;
        for (int j = 0; j < kSize; ++j)
            for (int i = 0; i < kSize; ++i) {
                const MarchedRatio marched = ratioByMarching(map, i, j);
                const double c = *cones.at(0, kConeTexels, i, j);
                sumLeast += marched.least;
                sumMost += marched.most;
                sum += c;
                if (c < marched.least - 2.0 / kSize || c > marched.most + 2.0 / kSize) ++farOff;
            }
        constexpr double kTexels = kSize * kSize, kMarchingStep = 1.0 / 32 / kSize;
        EXPECT_GE(sum / kTexels, sumLeast / kTexels - kMarchingStep) << kind;
        EXPECT_LE(sum / kTexels, sumMost / kTexels + kMarchingStep) << kind;
        EXPECT_LE(farOff, kTexels / 100) << kind;
        RecordProperty(kind, std::to_string(farOff) + " of 1024 more than two texels off");
    }
}

TEST(ConeMap, AnyThreadCount_GivesEqualBits) {
    const HeightMap map = generateMap("noise", 96, 1, Wrap::Repeat, Wrap::Repeat);
    for (const char* kind : kKinds) {
        const BakedMap all = bake(map, kind);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(all.levels[0].values, bake(map, kind).levels[0].values);
    }
}

TEST(ConeMap, Kinds_AreFoundByName) {
    for (const char* kind : kKinds)
        EXPECT_TRUE(isBakeKind(kind));
    EXPECT_THROW(coneRule("normal"), InputError);
}

} // namespace
} // namespace plumbline
