// The searches of realtime/techniques/ that only use the height map, with rays whose hits are known.
#include "tests/realtime/draw/search_rays.h"

#include <algorithm>
#include <cstring>

namespace plumbline {
namespace {

// --- roots known by hand -------------------------------------------------------------------------

TEST(KnownRoots, ConstantDepth_IsExact) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const HeightMap map = HeightMap::constant("constant", 0.37f);
    const ReliefLine line{{0.2f, 0.7f}, {0.4f, -0.3f}};
    // Steps of 1/10: the first at or below 0.37 is 0.4. Halvings of [0,1]: 24/64 = 0.375. Of [0.3, 0.4]:
    // 0.1/64 each, 45 of which are 0.0703. The others intersect a straight line. Lookups: the steps up to the
    // hit, one more for searches that need the gap at t = 0, and one per refinement.
    const struct {
        const char* technique;
        double t, tolerance;
        int iterations, lookups;
    } cases[] = {{"linear", 0.4, 0, 0, 4},
                 {"binary", 0.375, 0, 6, 6},
                 {"linear_binary", 0.3 + 45 * 0.1 / 64, 0, 6, 10},
                 {"linear_secant1", 0.37, 0, 1, 5},
                 {"linear_secant", 0.37, 0, 1, 4},
                 {"linear_secant:method=regula_falsi", 0.37, 0, 1, 4},
                 {"linear_secant:answer=sampled_depth", 0.37, 0, 1, 4},
                 {"exact_cells", 0.37, 0, 1, 1},
                 {"parallax", 0.37, 0, 0, 1},
                 {"parallax:scale=0.5,bias=-0.25", -0.065, 0, 0, 1}};
    for (const auto& c : cases) {
        const TracedHit hit = traceOne(c.technique, map, line);
        EXPECT_TRUE(hit.hit) << c.technique;
        EXPECT_NEAR(hit.t, c.t, 4 * kFloatEpsilon) << c.technique;
        EXPECT_EQ(hit.iterations, c.iterations) << c.technique;
        EXPECT_EQ(hit.lookups, c.lookups) << c.technique;
    }
    // Half of the descent: cosine 0.5.
    EXPECT_NEAR(traceOne("parallax_offset_limited", map, line, {1, 0, 0.5f}).t, 0.5 * 0.37,
                4 * kFloatEpsilon);
}

TEST(KnownRoots, Ramp_IsExact) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Two clamped texels: D = 2 (s - 1/4) between their centers. From s = 0.3 over 0.1: D = 0.1 + 0.2 t = t
    // at t = 1/8.
    const HeightMap map = profile({0, 1}, Wrap::Clamp);
    const ReliefLine line{{0.3f, 0.5f}, {0.1f, 0}};
    EXPECT_NEAR(traceOne("exact_cells", map, line).t, 0.125, 4 * kFloatEpsilon);
    EXPECT_NEAR(traceOne("linear_secant1", map, line).t, 0.125, 4 * kFloatEpsilon);
    EXPECT_NEAR(traceOne("linear_secant", map, line).t, 0.125, 4 * kFloatEpsilon);
    EXPECT_NEAR(traceOne("linear", map, line).t, 0.2, kFloatEpsilon);
    EXPECT_NEAR(traceOne("linear_binary", map, line).t, 0.125, 0.1 / 64);
    EXPECT_NEAR(traceOne("binary", map, line).t, 0.125, 1.0 / 64);
    // Beyond the border the map continues at depth 0 on the left and 1 on the right, at any distance.
    EXPECT_EQ(traceOne("exact_cells", map, {{-40, 0.5f}, {0.1f, 0}}).t, 0);
    EXPECT_EQ(traceOne("exact_cells", map, {{40, 0.5f}, {-0.1f, 0}}).t, 1);
    // The ray starts on the relief, at D = 0, although the relief descends faster than the ray.
    EXPECT_EQ(traceOne("exact_cells", map, {{0.25f, 0.5f}, {2, 0}}).t, 0);
    // To the right over 80 tiles: beyond the border there is only one cell.
    EXPECT_EQ(traceOne("exact_cells", map, {{0.5f, 0.5f}, {80, 0}}).iterations, 2);
    // From the right over 80 tiles: D = 2 (s - 1/4) = t at s = 40 - 80 t gives t = 79.5 / 161, in 2 cells.
    const TracedHit in = traceOne("exact_cells", map, {{40, 0.5f}, {-80, 0}});
    EXPECT_NEAR(in.t, 79.5 / 161, 1e-6);
    EXPECT_EQ(in.iterations, 2);
}

TEST(KnownRoots, Step_IsHitOnItsWall) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Depth 1 from s = 0.1 to s = 0.5: a ray from s = 0.3 hits the wall between texels 31 and 32 of 64, whose
    // centers are at s = 31.5/64 and 32.5/64. D = 1 - (64 s - 31.5) there, with s = 0.3 + 0.4 t: D = t at t =
    // 13.3 / 26.6.
    std::vector<float> depths(64, 0);
    std::fill(depths.begin() + 6, depths.begin() + 32, 1.0f);
    const HeightMap map = profile(depths);
    const ReliefLine line{{0.3f, 0.5f}, {0.4f, 0}};
    const double truth = 13.3 / 26.6;
    EXPECT_NEAR(trueFirstHit(map, line).hit->t, truth, 1e-6);
    EXPECT_NEAR(traceOne("exact_cells", map, line).t, truth, 1e-6);
    EXPECT_NEAR(traceOne("linear:linear_steps=100", map, line).t, truth, 0.0101);
    EXPECT_NEAR(traceOne("linear_binary:linear_steps=20,binary_steps=12", map, line).t, truth, 0.06 / 4096);
    EXPECT_NEAR(traceOne("linear_secant1:linear_steps=100", map, line).t, truth, 0.01);
    EXPECT_NEAR(traceOne("linear_secant:linear_steps=20,tolerance=0.0001", map, line).t, truth, 1e-4);
}

TEST(KnownRoots, TwoBumps_FirstIsHitExceptByBisection) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Ridges between texels 20 and 24, and 44 and 50, of 64; the ray crosses the whole map. It enters the
    // first where D falls from 1 to 0 between the centers of texels 19 and 20: 1 - (64 t - 19.5) = t, t
    // = 20.5 / 65. The midpoint is between the ridges, so bisection continues in the second half and finds
    // the second ridge at 44.5 / 65.
    const HeightMap map = ridge(64, {{20, 24}, {44, 50}});
    const ReliefLine line{{0, 0.5f}, {1, 0}};
    const double truth = 20.5 / 65, second = 44.5 / 65;
    EXPECT_NEAR(traceOne("exact_cells", map, line).t, truth, 2 * kFloatEpsilon);
    EXPECT_NEAR(traceOne("linear:linear_steps=32", map, line).t, truth, 1.0 / 32);
    EXPECT_NEAR(traceOne("linear_binary:linear_steps=32,binary_steps=12", map, line).t, truth, 2e-5);
    EXPECT_NEAR(traceOne("linear_secant1:linear_steps=32", map, line).t, truth, 1.0 / 32);
    EXPECT_NEAR(traceOne("linear_secant:linear_steps=32", map, line).t, truth, 2e-3);
    EXPECT_NEAR(traceOne("binary:binary_steps=20", map, line).t, second, 2e-6);
}

TEST(KnownRoots, NeedleOneTexelWide_IsSkippedByCoarseSteps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // One texel of 64 of depth 0: D = 1 - (64 t - 32.5) = t at t = 33.5 / 65 = 0.515. Steps of 1/10 pass at
    // 0.5 and 0.6.
    const HeightMap map = ridge(64, {{33, 34}});
    const ReliefLine line{{0, 0.5f}, {1, 0}};
    EXPECT_NEAR(traceOne("exact_cells", map, line).t, 33.5 / 65, 2 * kFloatEpsilon);
    for (const char* coarse : {"linear", "linear_binary", "linear_secant1", "linear_secant"})
        EXPECT_GT(traceOne(coarse, map, line).t, 0.9) << coarse;
    for (const char* fine : {"linear", "linear_binary", "linear_secant1", "linear_secant"})
        EXPECT_NEAR(traceOne(fine + std::string(":linear_steps=128"), map, line).t, 33.5 / 65, 1.0 / 128)
            << fine;
}

TEST(KnownRoots, FloorAndTop_AreHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const ReliefLine lines[] = {{{0.3f, 0.3f}, {0.7f, 0.1f}}, {{0.3f, 0.3f}, {0, 0}}, {{-3, 9}, {-40, 3}}};
    for (const std::string& search : kSearches)
        for (const ReliefLine& line : lines) {
            const TracedHit floor = traceOne(search, HeightMap::constant("floor", 1), line);
            EXPECT_TRUE(floor.hit && floor.t == 1) << search << " " << floor.t;
            const TracedHit top = traceOne(search, HeightMap::constant("top", 0), line);
            const double firstStep = search == "linear" ? 0.1 : search == "binary" ? 1.0 / 64 : 0.1 / 64;
            EXPECT_TRUE(top.hit && top.t <= firstStep + kFloatEpsilon) << search << " " << top.t;
        }
    // A ray that leaves the layer doesn't reach the floor.
    for (const std::string& search : kSearches)
        EXPECT_FALSE(traceOne(search, HeightMap::constant("floor", 1), lines[0], {0, 3.5f}).hit) << search;
}

TEST(KnownRoots, PrematureBisectionAsPrinted_StaysNearTop) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // E6: steps of 1/12, 1/24, ... add up to (1 - 1/64) / 6 = 0.164 for six: a relief at depth 0.7 (height
    // 0.3) is reported at height 0.836.
    const HeightMap map = HeightMap::constant("constant", 0.7f);
    EXPECT_NEAR(traceOne("binary:interval=printed", map, {{0, 0}, {0, 0}}).t, 1 - 0.836, 1e-4);
    EXPECT_NEAR(traceOne("binary", map, {{0, 0}, {0, 0}}).t, 0.7, 1.0 / 64);
}

// --- exact_cells against double ------------------------------------------------------------------

struct ExactCase {
    const char* name;
    HeightMap map;
};

std::vector<ExactCase> exactCases() {
    std::vector<ExactCase> cases;
    cases.push_back({"random repeat", randomMap(37, 23, Wrap::Repeat, Wrap::Repeat)});
    cases.push_back({"random clamp", randomMap(37, 23, Wrap::Clamp, Wrap::Clamp)});
    cases.push_back({"random clamp s", randomMap(16, 64, Wrap::Clamp, Wrap::Repeat)});
    cases.push_back({"random clamp t", randomMap(5, 300, Wrap::Repeat, Wrap::Clamp)});
    cases.push_back({"two texels", randomMap(2, 2, Wrap::Repeat, Wrap::Repeat)});
    cases.push_back({"one texel", HeightMap::constant("one", 0.6f)});
    for (const char* kind : {"bricks", "pins", "waves", "cobbles"})
        cases.push_back({kind, generated(kind, 128)});
    return cases;
}

TEST(ExactCells, AnyRay_EqualsDoubleRootUnlessGrazing) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The error of the hit's depth is below 1e-5 of the relief, unless the gap decreases by less than 0.05
    // per unit of t at the hit or came within 1e-5 of 0 at an earlier extremum: then rounding errors of the
    // gap, a few 1e-7, move the hit by more.
    size_t compared = 0, grazing = 0;
    double largest = 0;
    for (const ExactCase& c : exactCases())
        for (const ReliefPath& path : {ReliefPath{1, 0}, ReliefPath{1, 0.9f}, ReliefPath{1, -0.8f},
                                       ReliefPath{0, 3.5f}, ReliefPath{0, 1}})
            for (const float travel : {0.0f, 1e-4f, 0.03f, 0.3f, 2.5f}) {
                const std::vector<ReliefLine> lines = raysOfLength(travel, 200, -2, 3);
                const std::vector<TracedHit> found = traceGlsl("exact_cells", c.map, lines, path);
                for (size_t i = 0; i < lines.size(); ++i) {
                    const TrueTrace truth = trueFirstHit(c.map, lines[i], path);
                    SCOPED_TRACE(testing::Message()
                                 << c.name << " travel " << travel << " end " << path.endDepth << " bend "
                                 << path.bend << " ray " << i);
                    ASSERT_FALSE(std::isnan(found[i].t));
                    if (truth.nearMiss < 1e-5 || (truth.hit && truth.hit->descent < 0.05)) {
                        ++grazing;
                        continue;
                    }
                    ++compared;
                    ASSERT_EQ(found[i].hit, truth.hit.has_value());
                    if (!truth.hit) continue;
                    ASSERT_NEAR(found[i].t, truth.hit->t, 1e-5) << "descent " << truth.hit->descent;
                    largest = std::max(largest, std::abs(found[i].t - truth.hit->t));
                }
            }
    EXPECT_GT(compared, 40 * grazing) << grazing;
    RecordProperty("largest_error", std::to_string(largest));
    RecordProperty("grazing", std::to_string(grazing));
    RecordProperty("compared", std::to_string(compared));
}

TEST(ExactCells, AnyRay_VisitsOnlyCrossedCells) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A floor at depth 1: the whole ray is traversed with one lookup per cell.
    const HeightMap map("floor", 16, 8, std::vector<float>(128, 1));
    for (const ReliefLine& line : raysOfLength(1.7f, 300, -2, 3)) {
        const auto cellAt = [&](double t, int axis) {
            const int size = axis == 0 ? 16 : 8;
            return std::floor((double(line.st[axis]) + t * double(line.stTravel[axis])) * size - 0.5);
        };
        const int cells = 1 + static_cast<int>(std::abs(cellAt(1, 0) - cellAt(0, 0)) +
                                               std::abs(cellAt(1, 1) - cellAt(0, 1)));
        const TracedHit hit = traceOne("exact_cells", map, line);
        ASSERT_NEAR(hit.iterations, cells, 1)
            << line.st.x << " " << line.st.y; // an end on a border belongs to either cell
        ASSERT_EQ(hit.lookups, hit.iterations);
    }
}

TEST(ExactCells, CellBudget_StopsSearch) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const HeightMap map("floor", 16, 1, std::vector<float>(16, 1));
    // 4 of the 16 cells from s = 0: the first ends after half a texel, and the fifth begins at t = 3.5/16.
    const TracedHit hit = traceOne("exact_cells:most_cells=4", map, {{0, 0}, {1, 0}});
    EXPECT_TRUE(hit.hit);
    EXPECT_NEAR(hit.t, 3.5 / 16, kFloatEpsilon);
    EXPECT_EQ(hit.iterations, 4);
}

TEST(ExactCells, ManyTiles_AreFollowed) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Grazing rays over 7 tiles of 512 texels, far from 0, with one needle, one texel wide, on the way.
    std::vector<float> depths(512 * 512, 1);
    depths[200 * 512 + 100] = 0;
    const HeightMap map("needle", 512, 512, std::move(depths));
    size_t onNeedle = 0;
    std::vector<ReliefLine> lines;
    for (int i = 0; i < 64; ++i) { // past the needle of the fifth tile, at up to 1.6 texels from its center
        const double t = (5 + 100.5 / 512 - 0.25) / 7;
        lines.push_back(
            {{0.25f, static_cast<float>(3 + (200.5 + (i - 32) / 20.0) / 512 - t * 0.5)}, {7, 0.5f}});
    }
    const std::vector<TracedHit> found = traceGlsl("exact_cells", map, lines);
    for (size_t i = 0; i < lines.size(); ++i) {
        const TrueTrace truth = trueFirstHit(map, lines[i]);
        ASSERT_TRUE(truth.hit && found[i].hit);
        onNeedle += truth.hit->t < 0.99;
        if (truth.nearMiss > 1e-3 && truth.hit->descent > 0.05) {
            ASSERT_NEAR(found[i].t, truth.hit->t, 1e-5) << i;
        }
    }
    EXPECT_GT(onNeedle, 20u);
    EXPECT_LT(onNeedle, 64u);
}

TEST(Bisection, Tolerance_StopsSearch) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // D = 0.37 at [0.3, 0.4]: midpoints 0.35, 0.375: |gap| 0.005 <= 0.01 after two steps.
    const HeightMap map = HeightMap::constant("constant", 0.37f);
    const TracedHit hit = traceOne("linear_binary:tolerance=0.01", map, {{0, 0}, {0.1f, 0}});
    EXPECT_EQ(hit.iterations, 2);
    EXPECT_NEAR(hit.t, 0.375, kFloatEpsilon);
}

TEST(LinearSteps, Angle_AdaptsSteps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Premecz: lerp(2N, N, cosine), rounded up. A floor at depth 1 needs all of them: 10, 15, 20; 16.3 is
    // rounded up to 17.
    const HeightMap floor = HeightMap::constant("floor", 1);
    for (const auto& [cosine, steps] : {std::pair(1.0f, 10), {0.5f, 15}, {0.0f, 20}, {0.37f, 17}})
        EXPECT_EQ(
            traceOne("linear_binary:steps=adaptive,binary_steps=0", floor, {{0, 0}, {0, 0}}, {1, 0, cosine})
                .lookups,
            steps);
}

TEST(LinearSteps, NoEarlyExit_GivesSameHitAtFullCost) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const HeightMap map = generated("bricks", 64);
    const std::vector<ReliefLine> lines = raysOfLength(0.3f, 500);
    const auto with = traceGlsl("linear_binary", map, lines);
    const auto without = traceGlsl("linear_binary:early_exit=false", map, lines);
    for (size_t i = 0; i < lines.size(); ++i) {
        ASSERT_EQ(with[i].t, without[i].t);
        ASSERT_EQ(without[i].lookups, 16);
        ASSERT_LE(with[i].lookups, 16);
    }
}

TEST(CurvedRays, EverySearch_FindsHitOrLeavesLayer) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // With 256 steps on a smooth map, accurate to a step except for a few rays that graze a wave.
    const HeightMap map = generated("waves", 64);
    const std::vector<ReliefLine> lines = raysOfLength(0.5f, 1000);
    for (const ReliefPath& path :
         {ReliefPath{1, 0.9f}, ReliefPath{1, -0.8f}, ReliefPath{0, 3.0f}, ReliefPath{0, 0.5f}})
        for (const char* search :
             {"linear:linear_steps=256", "linear_binary:linear_steps=256", "linear_secant1:linear_steps=256",
              "linear_secant:linear_steps=256", "binary"}) {
            const auto found = traceGlsl(search, map, lines, path);
            size_t wrong = 0, missedHits = 0, inventedHits = 0;
            for (size_t i = 0; i < lines.size(); ++i) {
                const TrueTrace truth = trueFirstHit(map, lines[i], path);
                ASSERT_FALSE(std::isnan(found[i].t));
                missedHits += truth.hit && !found[i].hit;
                inventedHits += !truth.hit && found[i].hit;
                wrong += truth.hit && found[i].hit && std::abs(found[i].t - truth.hit->t) > 1.0 / 256 + 1e-4;
            }
            SCOPED_TRACE(testing::Message() << search << " end " << path.endDepth << " bend " << path.bend);
            EXPECT_EQ(inventedHits, 0u); // every ray that enters the relief has a hit
            if (std::string(search) == "binary") continue;
            EXPECT_LE(missedHits, 10u);
            EXPECT_LE(wrong, 10u);
        }
}

} // namespace
} // namespace plumbline
