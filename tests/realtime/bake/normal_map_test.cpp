// Normals of the relief: closed forms, borders, scales.
#include "realtime/bake/bake.h"
#include "scenes/core/error.h"
#include "tests/realtime/bake/awkward_maps.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

BakedMap normalsOf(const HeightMap& map, const BakeScale& scale) {
    return bakeMap(map, {.kind = "normal", .scale = scale, .slices = 1});
}

void expectNormal(const float* texel, const Vec3& expected) {
    const Vec3 unit = glm::normalize(expected);
    for (int k = 0; k < 3; ++k)
        EXPECT_FLOAT_EQ(texel[k], static_cast<float>(unit[k])) << "component " << k;
}

TEST(NormalMap, FlatRelief_PointsOutward) {
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp}) {
        const BakedMap normals =
            normalsOf(HeightMap("flat", 3, 2, std::vector<float>(6, 0.25f), wrap, wrap), {2, 3, 0.5});
        EXPECT_EQ(normals.kind, "normal");
        EXPECT_EQ(normals.channels, 4);
        ASSERT_EQ(normals.levels.size(), 1u);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 3; ++i) {
                const float* texel = normals.at(0, 0, i, j);
                EXPECT_EQ(std::vector(texel, texel + 4), (std::vector{0.0f, 0.0f, 1.0f, 0.25f}));
            }
    }
}

// The depth increases by 1/8 per texel along s on 4 columns, so D_s = 1/2 per map width. On a tile of 2 x 5
// world units with depth 3, the relief descends by 3/2 over 2 units: z = -(3/4) x, normal (3/4, 0, 1).
// Likewise along t. The clamped border has half the slope, the repeated one a jump of -3/8 against 1/8: (-3/8
// + 1/8)/2 = -1/8 a texel.
TEST(NormalMap, LinearRelief_HasClosedForm) {
    std::vector<float> depths;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i)
            depths.push_back(static_cast<float>(i) / 8);
    const BakeScale scale{2, 5, 3};
    const BakedMap clamped = normalsOf(HeightMap("ramp", 4, 3, depths, Wrap::Clamp, Wrap::Clamp), scale);
    const BakedMap repeated = normalsOf(HeightMap("ramp", 4, 3, depths), scale);
    for (int j = 0; j < 3; ++j) {
        expectNormal(clamped.at(0, 0, 0, j), {0.375, 0, 1});
        expectNormal(clamped.at(0, 0, 1, j), {0.75, 0, 1});
        expectNormal(clamped.at(0, 0, 3, j), {0.375, 0, 1});
        expectNormal(repeated.at(0, 0, 0, j), {-0.75, 0, 1});
        expectNormal(repeated.at(0, 0, 2, j), {0.75, 0, 1});
    }
    // Rotated by 90 degrees: 4 rows, 3 columns, the tile 5 along s and 2 along t.
    std::vector<float> turned;
    for (int j = 0; j < 4; ++j)
        turned.insert(turned.end(), 3, static_cast<float>(j) / 8);
    const BakedMap alongT = normalsOf(HeightMap("ramp", 3, 4, turned, Wrap::Clamp, Wrap::Clamp), {5, 2, 3});
    expectNormal(alongT.at(0, 0, 1, 0), {0, 0.375, 1});
    expectNormal(alongT.at(0, 0, 1, 2), {0, 0.75, 1});
}

// The central difference is the mean of the exact bilinear surface's gradients on both sides of a texel
// center.
TEST(NormalMap, Texel_IsMeanOfSurroundingSlopes) {
    for (const HeightMap& map : awkwardMaps()) {
        SCOPED_TRACE(describe(map));
        const BakeScale scale{1.5, 0.8, 0.3};
        const BakedMap normals = normalsOf(map, scale);
        for (int j = 0; j < map.height(); ++j)
            for (int i = 0; i < map.width(); ++i) {
                const Vec2 center((i + 0.5) / map.width(), (j + 0.5) / map.height());
                const Vec2 aside(0.25 / map.width(), 0.25 / map.height());
                const auto slope = [&](int axis) {
                    Vec2 step(0);
                    step[axis] = aside[axis];
                    return (map.sample(center + step).gradient[axis] +
                            map.sample(center - step).gradient[axis]) /
                           2;
                };
                expectNormal(normals.at(0, 0, i, j),
                             {slope(0) * scale.depth / scale.s, slope(1) * scale.depth / scale.t, 1});
                EXPECT_EQ(normals.at(0, 0, i, j)[3], map.texel(i, j));
            }
    }
}

TEST(NormalMap, Normals_AreUnitAndDependOnRatios) {
    const HeightMap map = noiseMap(31, 17, 8);
    const BakedMap normals = normalsOf(map, {1, 2, 0.5}), larger = normalsOf(map, {1024, 2048, 512}),
                   deeper = normalsOf(map, {1, 2, 0.6});
    EXPECT_TRUE(sameBits(normals.levels[0].values, larger.levels[0].values));
    EXPECT_FALSE(sameBits(normals.levels[0].values, deeper.levels[0].values));
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            const float* n = normals.at(0, 0, i, j);
            EXPECT_NEAR(glm::length(Vec3(n[0], n[1], n[2])), 1, 1e-7);
            EXPECT_GT(n[2], 0);
        }
}

TEST(NormalMap, OneThread_GivesEqualBits) {
    const HeightMap map = noiseMap(300, 200, 4);
    const auto make = [&] { return normalsOf(map, {1, 1, 0.1}); };
    EXPECT_TRUE(sameBits(make().levels[0].values, onOneThread(make).levels[0].values));
}

TEST(NormalMap, ScalesWithoutSlope_AreRefused) {
    const HeightMap map = noiseMap(2, 2, 1);
    for (const BakeScale& scale :
         {BakeScale{0, 1, 1}, BakeScale{1, 1, -1}, BakeScale{1, kInfinity, 1}, BakeScale{1, std::nan(""), 1},
          BakeScale{1e-300, 1, 1e300}, BakeScale{1, 1, 1e-10}})
        EXPECT_THROW(normalsOf(map, scale), InputError) << scale.s << " " << scale.t << " " << scale.depth;
}

} // namespace
} // namespace plumbline
