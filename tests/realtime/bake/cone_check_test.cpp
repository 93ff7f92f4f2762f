#include "realtime/bake/bake.h"
#include "realtime/bake/cone_check.h"
#include "scenes/core/error.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "tests/realtime/bake/cone_test_maps.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace plumbline {
namespace {

constexpr uint64_t kRays = 200000, kSeed = 1;

BakedMap bake(const HeightMap& map, const std::string& kind) {
    BakeRequest request;
    request.kind = kind;
    return bakeMap(map, request);
}

bool isRelaxed(const std::string& kind) {
    return kind.find("relaxed") != std::string::npos;
}

/// A step is computed in double from ratios that are rounded down, so it ends inside its cone by more than
/// rounding errors, and there is no overshoot at all.
TEST(ConeCheck, CellSteps_NeverSkipSurface) {
    for (const std::string& generated : generatedMapKinds()) {
        const HeightMap map = generateMap(generated, 64, 1, Wrap::Repeat, Wrap::Repeat);
        for (const char* kind : {"cone_step", "cone_step_quad", "cone_step_relaxed"}) {
            const ConeCheck check =
                checkCones(map, bake(map, kind), ConeLookup::Cell, isRelaxed(kind), kRays, kSeed);
            EXPECT_EQ(check.rays, kRays);
            EXPECT_GT(check.pierced, kRays / 2);
            EXPECT_EQ(check.overshoots, 0u)
                << kind << " of " << generated << ": " << check.deepest << " deep";
        }
    }
}

TEST(ConeCheck, ClampedBordersAndOddSizes_NeverSkipSurface) {
    for (const TestMap& test : smallMaps())
        for (const char* kind : {"cone_step", "cone_step_quad", "cone_step_relaxed"}) {
            const ConeCheck check =
                checkCones(test.map, bake(test.map, kind), ConeLookup::Cell, isRelaxed(kind), 20000, kSeed);
            EXPECT_EQ(check.overshoots, 0u)
                << kind << " of " << test.name << ": " << check.deepest << " deep";
        }
}

/// TECHNIQUES.md, E20: "never misses" is only true at texel centers.
TEST(ConeCheck, InterpolatedRatiosOfBricks_SkipSurface) {
    const HeightMap map = generateMap("bricks", 128, 1, Wrap::Repeat, Wrap::Repeat);
    const BakedMap cones = bake(map, "cone_step");
    EXPECT_GT(checkCones(map, cones, ConeLookup::Bilinear, false, kRays, kSeed).overshootingRays,
              kRays / 100);
    EXPECT_GT(checkCones(map, cones, ConeLookup::Nearest, false, kRays, kSeed).overshootingRays, kRays / 100);
    const ConeCheck four = checkCones(map, cones, ConeLookup::MinOfFour, false, kRays, kSeed);
    EXPECT_LT(four.overshootingRays, kRays / 50);
}

/// TECHNIQUES.md, E19: cones computed for rays from depth 0 don't stop rays that start deeper at shallower
/// angles. The cell lookup excludes other causes; with the conservative map the same rays don't overshoot.
TEST(ConeCheck, ConesOf2007_SkipSurface) {
    for (const char* generated : {"noise", "cobbles", "waves"}) {
        const HeightMap map = generateMap(generated, 128, 1, Wrap::Repeat, Wrap::Repeat);
        const ConeCheck published =
            checkCones(map, bake(map, "cone_step_relaxed_2007"), ConeLookup::Cell, true, kRays, kSeed);
        EXPECT_GT(published.overshootingRays, kRays / 10000) << generated;
        EXPECT_GT(published.deepest, 1.0 / 255) << generated;
    }
}

/// The check detects cones that are 20 % too wide.
TEST(ConeCheck, WidenedCones_SkipSurface) {
    const HeightMap map = generateMap("bricks", 64, 1, Wrap::Repeat, Wrap::Repeat);
    for (const char* kind : {"cone_step", "cone_step_quad", "cone_step_relaxed"}) {
        BakedMap cones = bake(map, kind);
        for (float& ratio : cones.levels[0].values)
            ratio *= 1.2f;
        const ConeCheck check = checkCones(map, cones, ConeLookup::Cell, isRelaxed(kind), kRays, kSeed);
        EXPECT_GT(check.overshoots, 0u) << kind;
        EXPECT_GT(check.deepest, 1e-5) << kind;
        uint64_t counted = 0;
        for (const uint64_t overshoots : check.overshootsByDepth)
            counted += overshoots;
        EXPECT_EQ(counted, check.overshoots);
        // The reported ray reaches the reported depth within the reported step.
        std::vector<InsideInterval> intervals;
        walkRelief(map, check.deepestRay, check.deepestFrom, check.deepestTo, intervals);
        double deepest = 0;
        for (const InsideInterval& interval : intervals)
            deepest = std::max(deepest, interval.deepest);
        EXPECT_NEAR(deepest, check.deepest, 1e-12);
    }
}

/// Depth 1/2 everywhere: cones of ratio 1, every ray hits it and none overshoots.
TEST(ConeCheck, FlatMap_IsReached) {
    const HeightMap map = HeightMap::constant("flat", 0.5f);
    const ConeCheck check = checkCones(map, bake(map, "cone_step"), ConeLookup::Cell, false, 10000, kSeed);
    EXPECT_EQ(check.pierced, 10000u);
    EXPECT_EQ(check.arrived, 10000u);
    EXPECT_EQ(check.overshoots, 0u);
    EXPECT_GT(check.meanSteps(), 1);
}

TEST(ConeCheck, AnyThreadCount_GivesEqualResult) {
    const HeightMap map = generateMap("cobbles", 64, 1, Wrap::Repeat, Wrap::Repeat);
    const BakedMap cones = bake(map, "cone_step");
    const ConeCheck all = checkCones(map, cones, ConeLookup::Nearest, false, 50000, kSeed);
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    const ConeCheck one = checkCones(map, cones, ConeLookup::Nearest, false, 50000, kSeed);
    EXPECT_GT(all.overshoots, 0u);
    EXPECT_EQ(all.overshootsByDepth, one.overshootsByDepth);
    EXPECT_EQ(all.arrivalSteps, one.arrivalSteps);
    EXPECT_EQ(all.deepest, one.deepest);
    EXPECT_EQ(all.deepestRay.origin, one.deepestRay.origin);
    EXPECT_NE(all.overshoots,
              checkCones(map, cones, ConeLookup::Nearest, false, 50000, kSeed + 1).overshoots);
}

TEST(ConeCheck, MapsThatDontMatch_AreRefused) {
    const HeightMap map = HeightMap::constant("flat", 0.5f);
    BakedMap cones = bake(map, "cone_step");
    const HeightMap other("other", 2, 1, {0, 1});
    EXPECT_THROW(checkCones(other, cones, ConeLookup::Cell, false, 10, kSeed), InputError);
    cones.kind = "normal";
    EXPECT_THROW(checkCones(map, cones, ConeLookup::Cell, false, 10, kSeed), InputError);
}

/// The distinct height maps of the library.
std::vector<std::shared_ptr<const HeightMap>> libraryMaps() {
    std::vector<std::shared_ptr<const HeightMap>> maps;
    for (const LibraryScene& entry : libraryScenes())
        for (const SceneObject& object : readScene(entry.file).objects) {
            if (!object.relief) continue;
            const auto& map = object.relief->map;
            const bool known = std::any_of(maps.begin(), maps.end(), [&](const auto& other) {
                return other->depths() == map->depths() && other->width() == map->width() &&
                       other->wrapS() == map->wrapS() && other->wrapT() == map->wrapT();
            });
            if (!known) maps.push_back(map);
        }
    return maps;
}

/// PLUMBLINE_CONE_RAYS sets the number of rays per map (slow run: ten million). 1/255 of the depth would be
/// visible in an image; the guarantee is that there is no overshoot at all.
TEST(ConeCheck, LibraryMaps_NeverSkipSurface) {
    const char* asked = std::getenv("PLUMBLINE_CONE_RAYS");
    const uint64_t rays = asked ? std::strtoull(asked, nullptr, 10) : 20000;
    fmt::print("{:<36}{:>12}  {:<24}{:>12}{:>12}{:>12}{:>10}\n", "map", "texels", "kind, by cells",
               "skipping", "> 1/255", "deepest", "steps");
    for (const auto& map : libraryMaps())
        for (const std::string kind : {"cone_step", "cone_step_relaxed", "cone_step_relaxed_2007"}) {
            const ConeCheck check =
                checkCones(*map, bake(*map, kind), ConeLookup::Cell, isRelaxed(kind), rays, kSeed);
            fmt::print("{:<36}{:>12}  {:<24}{:>12}{:>12}{:>12.2g}{:>10.2f}\n", map->name(),
                       fmt::format("{} x {}", map->width(), map->height()), kind, check.overshootingRays,
                       check.overshootsByDepth[3] + check.overshootsByDepth[4], check.deepest,
                       check.meanSteps());
            if (kind == "cone_step_relaxed_2007") continue;
            EXPECT_EQ(check.overshoots, 0u) << kind << " of " << map->name();
            EXPECT_LE(check.deepest, 1.0 / 255) << kind << " of " << map->name();
        }
}

} // namespace
} // namespace plumbline
