// Generated height maps: seamlessness, full range, reproducibility, formulas and errors.
#include "scenes/maps/generate_map.h"
#include "scenes/maps/map_texels.h"
#include "tests/errors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>

namespace plumbline {
namespace {

HeightMap generate(const std::string& kind, int size, unsigned seed = 1) {
    return generateMap(kind, size, seed, Wrap::Repeat, Wrap::Repeat);
}

/// FNV-1a over the bits of the floats.
uint64_t digest(const HeightMap& map) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const float d : map.depths()) {
        uint32_t bits = std::bit_cast<uint32_t>(d);
        for (int byte = 0; byte < 4; ++byte, bits >>= 8)
            hash = (hash ^ (bits & 0xff)) * 0x100000001b3u;
    }
    return hash;
}

class GeneratedMap : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Kinds, GeneratedMap, testing::ValuesIn(generatedMapKinds()),
                         [](const auto& kind) { return kind.param; });

TEST_P(GeneratedMap, EveryKind_IsSeamless) {
    // Steps between neighbors across the border are no larger than the largest inside, along rows and
    // columns. The sizes include some that aren't divisible by the maps' lattices.
    for (const int size : {64, 100, 255, 256}) {
        const HeightMap map = generate(GetParam(), size);
        float inside[2] = {0, 0}, across[2] = {0, 0};
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i) {
                const float here = map.texel(i, j);
                float& right = i + 1 < size ? inside[0] : across[0];
                float& up = j + 1 < size ? inside[1] : across[1];
                right = std::max(right, std::abs(map.texel(i + 1, j) - here));
                up = std::max(up, std::abs(map.texel(i, j + 1) - here));
            }
        // On a smooth map, the step across the border may be the largest. Curvature makes it larger than the
        // next one by less than 5 % at these sizes.
        EXPECT_LE(across[0], 1.05f * inside[0] + 1e-6f) << size;
        EXPECT_LE(across[1], 1.05f * inside[1] + 1e-6f) << size;
    }
}

TEST_P(GeneratedMap, EveryKind_UsesRange) {
    const HeightMap map = generate(GetParam(), 256);
    const auto [low, high] = std::minmax_element(map.depths().begin(), map.depths().end());
    EXPECT_LT(*low, 0.05f); // HeightMap itself refuses values outside [0,1]
    EXPECT_GT(*high, 0.95f);
}

TEST_P(GeneratedMap, Seed_DeterminesMap) {
    const bool random = GetParam() != "pyramids" && GetParam() != "ramp";
    EXPECT_EQ(digest(generate(GetParam(), 96, 5)), digest(generate(GetParam(), 96, 5)));
    std::set<uint64_t> digests;
    for (const unsigned seed : {0u, 1u, 2u, 0xffffffffu})
        digests.insert(digest(generate(GetParam(), 96, seed)));
    EXPECT_EQ(digests.size(), random ? 4u : 1u);
}

TEST_P(GeneratedMap, AnySizeFromOneTexel_IsGenerated) {
    for (int size = 1; size <= 40; ++size) {
        const HeightMap map = generate(GetParam(), size);
        EXPECT_EQ(map.width(), size);
        EXPECT_EQ(map.height(), size);
    }
}

TEST_P(GeneratedMap, FixedSeed_HasKnownHash) {
    // A regression test: results are compared between machines, so a map must not depend on the compiler or C
    // library (verified with g++ 12 at -O0 and -O3 -march=native, and with clang 14). Change a number only
    // together with its formula.
    const std::map<std::string, uint64_t> expected = {
        {"cobbles", 0x4c35798fe0134802u}, {"bricks", 0xd969e742cbc6e685u}, {"pyramids", 0x502fa2e95586c325u},
        {"pins", 0x3ee0ad6272787f65u},    {"fins", 0x78b0fd09825f8725u},   {"waves", 0xdba7d798f4ab11c8u},
        {"ramp", 0x47fae9c1cdd41f25u},    {"noise", 0x671afb76b52e618au},
    };
    EXPECT_EQ(digest(generate(GetParam(), 64, 7)), expected.at(GetParam()))
        << std::hex << digest(generate(GetParam(), 64, 7));
}

TEST(GeneratedMapFormulas, Pyramids_FollowFormula) {
    const HeightMap map =
        generate("pyramids", 64); // 8 cells of 8 texels; centers at odd sixteenths of a cell
    EXPECT_FLOAT_EQ(map.texel(3, 3), 2 * 1.0 / 16); // beside the tip
    EXPECT_FLOAT_EQ(map.texel(4, 3), 2 * 1.0 / 16);
    EXPECT_FLOAT_EQ(map.texel(0, 3), 2 * 7.0 / 16); // beside the foot
    EXPECT_FLOAT_EQ(map.texel(8 + 3, 16 + 6), 2 * 5.0 / 16);
    // On the line through the center of a cell, depth is linear, also between texels.
    EXPECT_NEAR(map.depth({0.25 / 8, 3.5 / 64}), 0.5, 1e-6);
}

TEST(GeneratedMapFormulas, Ramp_FollowsFormula) {
    const HeightMap map = generate("ramp", 4);
    for (int j = 0; j < 4; ++j) {
        EXPECT_FLOAT_EQ(map.texel(0, j), 0.25);
        EXPECT_FLOAT_EQ(map.texel(1, j), 0.75);
        EXPECT_FLOAT_EQ(map.texel(2, j), 0.75);
        EXPECT_FLOAT_EQ(map.texel(3, j), 0.25);
    }
}

TEST(GeneratedMapFormulas, Waves_FollowFormula) {
    const HeightMap map = generate("waves", 32, 0); // seed 0: no phases
    for (const auto& [i, j] : {std::pair(0, 0), {5, 17}, {31, 8}, {16, 30}}) {
        const double s = 2 * kPi * (i + 0.5) / 32, t = 2 * kPi * (j + 0.5) / 32;
        const double expected =
            0.5 - (0.25 * std::sin(2 * s + t) + 0.15 * std::sin(3 * t - s) + 0.1 * std::sin(4 * s - 3 * t));
        EXPECT_NEAR(map.texel(i, j), expected, 1e-7); // a float's rounding
    }
    // Phases only translate the terms of the sum, so the mean, 1/2, and the mean square, 1/4 + sum of a^2/2,
    // don't change.
    const HeightMap moved = generate("waves", 32, 9);
    double mean = 0, square = 0;
    for (const float d : moved.depths()) {
        mean += d / 1024.0;
        square += double(d) * d / 1024.0;
    }
    EXPECT_NEAR(mean, 0.5, 1e-7);
    EXPECT_NEAR(square, 0.25 + (0.0625 + 0.0225 + 0.01) / 2, 1e-7);
}

TEST(GeneratedMapFormulas, PinsAndFins_AreOneToFourTexelsWide) {
    for (const char* kind : {"pins", "fins"}) {
        const HeightMap map = generate(kind, 256);
        std::set<int> widths;
        for (int j = 0; j < 256; ++j) {
            int width = 0; // no feature crosses the border of the map
            for (int i = 0; i < 256; ++i) {
                const float d = map.texel(i, j);
                EXPECT_TRUE(d == 0.0f || d == 1.0f);
                if (d == 0.0f) {
                    ++width;
                } else if (width > 0) {
                    widths.insert(width);
                    width = 0;
                }
            }
        }
        EXPECT_EQ(widths, (std::set<int>{1, 2, 3, 4})) << kind;
    }
}

TEST(GeneratedMapFormulas, Bricks_RunInBond) {
    const HeightMap map = generate("bricks", 256); // rows of 32 texels, bricks of 64, half a joint 1.8
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(map.texel(i, 32), 1.0f); // the joint between the first two rows
    for (int row = 0; row < 8; ++row)
        for (int brick = 0; brick < 4; ++brick) {
            const int middle = 32 * row + 16, joint = 64 * brick + (row % 2 ? 32 : 0);
            EXPECT_EQ(map.texel(joint, middle), 1.0f);
            EXPECT_LT(map.texel(joint + 32, middle), 0.3f); // top of a brick
        }
}

RC_GTEST_PROP(SineOfTurns, AnyTurn_EqualsStdSin, (const int numerator)) {
    const double turns = numerator / 65536.0; // exact, up to 32768 turns
    // Taylor's remainder (pi/2)^19 / 19! = 4e-14, and std::sin's argument is off by 2 pi turns 2^-53.
    RC_ASSERT(std::abs(sineOfTurns(turns) - std::sin(2 * kPi * (turns - std::floor(turns)))) < 1e-13);
}

std::string refusal(const std::string& kind, int size) {
    return inputErrorOf([&] { generate(kind, size); });
}

TEST(GeneratedMapErrors, UnknownKind_ListsChoices) {
    const std::string kinds = "cobbles, bricks, pyramids, pins, fins, waves, ramp or noise";
    EXPECT_EQ(refusal("brick", 64),
              "generate: kind 'brick' is unknown; expected " + kinds + "; did you mean 'bricks'?");
    EXPECT_EQ(refusal("", 64), "generate: kind '' is unknown; expected " + kinds);
    EXPECT_EQ(refusal("noise", 0), "generate 'noise': size = 0; expected a whole number from 1 to 16384");
    EXPECT_EQ(refusal("noise", -7), "generate 'noise': size = -7; expected a whole number from 1 to 16384");
    EXPECT_EQ(refusal("noise", 16385),
              "generate 'noise': size = 16385; expected a whole number from 1 to 16384");
}

} // namespace
} // namespace plumbline
