// The distance field compared with its definition and with closed forms, and its lower bound.
#include "realtime/bake/bake.h"
#include "tests/realtime/bake/awkward_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

using namespace test;

constexpr int kBox = 0, kCenter = 1; // channels

BakedMap fieldOf(const HeightMap& map, const BakeScale& scale, int slices) {
    return bakeMap(map, {.kind = "distance_field", .scale = scale, .slices = slices});
}

/// Distance of two voxels on one axis, using the nearest repetition.
int stepsApart(int a, int b, int size, Wrap wrap) {
    const int apart = std::abs(a - b);
    return wrap == Wrap::Repeat ? std::min(apart, size - apart) : apart;
}

/// Minimum of the bilinear depths at the 3 x 3 corners of the four pieces of a texel's box.
double minInBox(const HeightMap& map, int i, int j) {
    double least = 1;
    for (const int x : {-1, 0, 1})
        for (const int y : {-1, 0, 1})
            least = std::min(least, (static_cast<double>(map.texel(i, j)) + map.texel(i + x, j) +
                                     map.texel(i, j + y) + map.texel(i + x, j + y)) /
                                        4);
    return least;
}

/// The definition: the minimum over all solid voxels.
BakedMap definition(const HeightMap& map, const BakeScale& scale, int slices) {
    const int width = map.width(), height = map.height();
    const double sideS = 1 / (width * (scale.depth / scale.s)),
                 sideT = 1 / (height * (scale.depth / scale.t));
    const double sideDepth = 1.0 / slices;
    std::vector<double> squares[2];
    for (auto& channel : squares)
        channel.assign(static_cast<size_t>(slices * width * height), kInfinity);
    const auto square = [](double side, int steps) { return side * steps * (side * steps); };
    for (int solidJ = 0; solidJ < height; ++solidJ)
        for (int solidI = 0; solidI < width; ++solidI)
            for (int solidK = 0; solidK <= slices; ++solidK) {
                const bool below = solidK == slices; // the ground, which is solid for the center field
                const bool solidBox = !below && minInBox(map, solidI, solidJ) * slices <= solidK + 1;
                const bool solidCenter =
                    below || static_cast<double>(map.texel(solidI, solidJ)) * slices <= solidK + 0.5;
                for (int k = 0; k < slices; ++k)
                    for (int j = 0; j < height; ++j)
                        for (int i = 0; i < width; ++i) {
                            const int steps[3]{stepsApart(i, solidI, width, map.wrapS()),
                                               stepsApart(j, solidJ, height, map.wrapT()),
                                               std::abs(k - solidK)};
                            const auto voxel = static_cast<size_t>((k * height + j) * width + i);
                            for (const int channel : {kBox, kCenter}) {
                                if (!(channel == kBox ? solidBox : solidCenter)) continue;
                                const auto gap = [&](int axis) {
                                    return std::max(0, steps[axis] - (channel == kBox ? 1 : 0));
                                };
                                double& least = squares[channel][voxel];
                                least = std::min(least, square(sideDepth, gap(2)) + square(sideS, gap(0)) +
                                                            square(sideT, gap(1)));
                            }
                        }
            }
    BakedMap field;
    field.slices = slices;
    field.channels = 2;
    field.levels.push_back({width, height, {}});
    for (size_t voxel = 0; voxel < squares[0].size(); ++voxel) {
        const double box = std::sqrt(squares[kBox][voxel]);
        auto down = static_cast<float>(box);
        if (down > box) down = std::nextafter(down, 0.0f);
        field.levels[0].values.insert(field.levels[0].values.end(),
                                      {down, static_cast<float>(std::sqrt(squares[kCenter][voxel]))});
    }
    return field;
}

TEST(DistanceField, SmallMap_EqualsDefinition) {
    const std::vector<std::pair<BakeScale, int>> cases{
        {{1, 1, 0.1}, 8}, {{3, 0.7, 1}, 5}, {{1, 2, 5}, 1}, {{0.3, 0.3, 0.01}, 3}};
    for (const HeightMap& map : awkwardMaps())
        for (const auto& [scale, slices] : cases) {
            const BakedMap field = fieldOf(map, scale, slices);
            EXPECT_TRUE(sameBits(field.levels[0].values, definition(map, scale, slices).levels[0].values))
                << describe(map) << ", " << slices << " slices, scale " << scale.s << " " << scale.t << " "
                << scale.depth;
        }
}

TEST(DistanceField, SeveralBlocks_EqualDefinition) {
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp})
        for (const HeightMap& map : {needleMap(70, 3, 66, 1, wrap, wrap), needleMap(3, 70, 1, 2, wrap, wrap),
                                     noiseMap(45, 37, 2, wrap, wrap)}) {
            const BakeScale scale{1, 1.5, 2};
            EXPECT_TRUE(
                sameBits(fieldOf(map, scale, 4).levels[0].values, definition(map, scale, 4).levels[0].values))
                << describe(map);
        }
}

// A floor at depth 1/2 with 8 slices of 1/8. The floor touches slices 3 and 4, so slice k is 3 - k - 1 slices
// away from the first solid one. For centers, slice 4 is the first whose center, 9/16, is below 1/2.
TEST(DistanceField, FlatFloor_HasClosedForm) {
    const BakedMap field = fieldOf(HeightMap("floor", 6, 5, std::vector<float>(30, 0.5f)), {1, 1, 0.2}, 8);
    EXPECT_EQ(field.slices, 8);
    EXPECT_EQ(field.channels, 2);
    for (int k = 0; k < 8; ++k) {
        EXPECT_EQ(field.at(0, k, 3, 2)[kBox], static_cast<float>(std::max(0, 2 - k)) / 8) << k;
        EXPECT_EQ(field.at(0, k, 3, 2)[kCenter], static_cast<float>(std::max(0, 4 - k)) / 8) << k;
    }
}

// A needle of depth 0 on texel 8 of 16, a tile 2 units wide and 1 deep: a voxel is 1/8 wide, and the patches
// around the needle reach depth 1/2 half a texel away from it. In the top slice of 2 (depths 0 to 1/2) texels
// 7, 8 and 9 are solid, and voxel 3 is 3 voxels away from the nearest of them; the floor, in the second
// slice, touches it. Centers: texel 8 alone, 5/8 away, against the ground's 1 below: (2 slices of 1/2).
TEST(DistanceField, Needle_HasClosedForm) {
    const BakedMap needle = fieldOf(needleMap(16, 1, 8, 0), {2, 4000, 1}, 2);
    EXPECT_EQ(needle.at(0, 0, 3, 0)[kCenter], 0.625f);
    EXPECT_EQ(needle.at(0, 0, 8, 0)[kCenter], 0.0f);
    EXPECT_EQ(needle.at(0, 0, 3, 0)[kBox], 0.0f);
    const BakedMap finer = fieldOf(needleMap(16, 1, 8, 0), {2, 4000, 1}, 64);
    EXPECT_EQ(finer.at(0, 0, 8, 0)[kBox], 0.0f);
    EXPECT_EQ(finer.at(0, 31, 3, 0)[kBox], 0.375f);  // texel 7 is solid from depth 1/2 on, slice 31
    EXPECT_EQ(finer.at(0, 31, 13, 0)[kBox], 0.375f); // and texel 9
    EXPECT_EQ(finer.at(0, 31, 1, 0)[kBox],
              31.0f / 64); // the floor, from slice 63 on, is nearer: 0.48 against 0.625
}

TEST(DistanceField, EqualRatios_GiveEqualField) {
    const HeightMap map = noiseMap(9, 14, 6);
    EXPECT_TRUE(sameBits(fieldOf(map, {1, 3, 0.2}, 8).levels[0].values,
                         fieldOf(map, {0.5, 1.5, 0.1}, 8).levels[0].values));
}

TEST(DistanceField, OneThread_GivesEqualBits) {
    const HeightMap map = noiseMap(120, 77, 9);
    const auto make = [&] { return fieldOf(map, {1, 1, 0.3}, 16); };
    EXPECT_TRUE(sameBits(make().levels[0].values, onOneThread(make).levels[0].values));
}

// -------- the lower bound --------

/// A point of relief space and the technique's lookup there: the nearest voxel, wrapped or clamped, at any
/// depth.
struct FieldLookup {
    const HeightMap& map;
    const BakedMap& field;
    BakeScale scale;

    double bound(const Vec3& std) const {
        const auto index = [](double x, int size, Wrap wrap) {
            const double voxel = std::floor(x * size);
            if (wrap == Wrap::Clamp) return static_cast<int>(std::clamp(voxel, 0.0, size - 1.0));
            return static_cast<int>(voxel - std::floor(voxel / size) * size);
        };
        return field.at(0, index(std.z, field.slices, Wrap::Clamp), index(std.x, map.width(), map.wrapS()),
                        index(std.y, map.height(), map.wrapT()))[kBox];
    }
    /// In units of the relief's depth.
    double distance(const Vec3& a, const Vec3& b) const {
        return glm::length((a - b) * Vec3(scale.s / scale.depth, scale.t / scale.depth, 1));
    }
};

constexpr double kRounding = 1e-12; // of st in double and of the sums; distances here are of order 1

std::vector<HeightMap> mapsForRandomPoints() {
    std::vector<HeightMap> maps = awkwardMaps();
    maps.push_back(noiseMap(32, 24, 11, Wrap::Clamp, Wrap::Repeat));
    maps.push_back(needleMap(40, 40, 7, 21));
    return maps;
}

TEST(DistanceField, Bound_IsBelowDistance) {
    std::mt19937 random(71);
    std::uniform_real_distribution<double> place(-0.6, 1.6), depth(-0.3, 1.1), near(-0.15, 0.15);
    for (const HeightMap& map : mapsForRandomPoints())
        for (const BakeScale& scale : {BakeScale{1, 1, 0.1}, BakeScale{1, 3, 2}}) {
            const BakedMap field = fieldOf(map, scale, 12);
            const FieldLookup look{map, field, scale};
            for (int n = 0; n < 3000; ++n) {
                const Vec3 point(place(random), place(random), depth(random));
                const Vec2 st = n % 2 == 0 ? Vec2(place(random), place(random))
                                           : Vec2(point) + Vec2(near(random), near(random));
                const Vec3 surface(st, map.depth(st));
                ASSERT_GE(look.distance(point, surface) + kRounding, look.bound(point))
                    << describe(map) << ", point " << point.x << " " << point.y << " " << point.z
                    << ", surface at " << st.x << " " << st.y;
            }
        }
}

// Sphere tracing with the bound never passes through the surface, also from above the top.
TEST(DistanceField, RandomRays_NeverPassSurface) {
    std::mt19937 random(72);
    std::uniform_real_distribution<double> place(-0.3, 1.3), tilt(-3, 3);
    for (const HeightMap& map : mapsForRandomPoints()) {
        const BakeScale scale{1, 1, 0.4};
        const BakedMap field = fieldOf(map, scale, 16);
        const FieldLookup look{map, field, scale};
        for (int n = 0; n < 300; ++n) {
            Vec3 point(place(random), place(random), -0.2);
            const Vec3 direction(tilt(random), tilt(random), 1);
            const double length = look.distance(direction, Vec3(0));
            for (int step = 0; step < 40; ++step) {
                const double bound = look.bound(point);
                // Along the whole step, not only at its end.
                for (int part = 1; part <= 8; ++part) {
                    const Vec3 passed = point + direction * (bound / length * part / 8);
                    ASSERT_LE(passed.z, map.depth(Vec2(passed)) + kRounding) << describe(map);
                }
                point += direction * (bound / length);
                if (bound == 0) break;
            }
        }
    }
}

} // namespace
} // namespace plumbline
