// Validity of the certificate: pixels changed by a finer run must have been marked as uncertain.
#include "reference/reference.h"
#include "scenes/maps/generate_map.h"
#include "scenes/mesh/shapes/shapes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace plumbline {
namespace {

constexpr int kWidth = 200, kHeight = 150;

/// A random relief on one of the shapes in front of a floor, lit by a sun and a lamp; everything depends on
/// the seed.
Scene seededScene(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random);
    };
    const std::vector<std::string> kinds = generatedMapKinds();
    const auto relief = [&](double depth) {
        const std::string kind = kinds[random() % kinds.size()];
        const auto map = std::make_shared<HeightMap>(generateMap(kind, 32, seed, Wrap::Repeat, Wrap::Repeat));
        // Tiles that aren't aligned with the lattice.
        return Relief{map, depth, between(-0.05, 0.05), Vec2(between(0.7, 3.3), between(0.7, 3.3)),
                      Vec2(between(0, 1), between(0, 1))};
    };
    Scene scene;
    scene.name = fmt::format("seed {}", seed);
    scene.camera.positionWorld = {between(-2, 2), between(0.6, 3), between(2.5, 4)};
    scene.camera.targetWorld = {between(-0.3, 0.3), between(-0.3, 0.2), 0};
    if (seed % 3 == 2) {
        scene.camera.projection = Camera::Projection::Orthographic;
        scene.camera.viewHeight = 2.6;
    }
    scene.camera.width = kWidth;
    scene.camera.height = kHeight;
    SceneObject object;
    object.name = "shape";
    switch (seed % 5) {
    case 0:
        object.mesh = makeTorus(1, 0.4, 16, 8);
        break;
    case 1:
        object.mesh = makeSphere(0.9, 3);
        break;
    case 2:
        object.mesh = makeCylinder(0.7, 1.6, 10, 3);
        break;
    case 3:
        object.mesh = makeBox(Vec3(1.2, 0.9, 1), 2);
        break;
    default:
        object.mesh = makeTeapot(2);
        object.scale = 0.6;
        object.translate = {0, -0.8, 0};
    }
    object.rotateDegrees = {between(0, 60), between(0, 360), 0};
    object.relief = relief(between(0.03, 0.12));
    SceneObject floor;
    floor.name = "floor";
    floor.mesh = makePlane(5, 5, 5, 5);
    floor.translate = {0, -1.2, 0};
    floor.relief = relief(between(0.02, 0.1));
    scene.objects = {object, floor};
    Light sun, lamp;
    sun.name = "sun";
    sun.toLightWorld = glm::normalize(Vec3(between(-1, 1), between(0.2, 1), between(-1, 1)));
    lamp.name = "lamp";
    lamp.kind = Light::Kind::Point;
    lamp.positionWorld = {between(-2, 2), between(1, 2.5), between(-1, 2)};
    scene.lights = {sun, lamp};
    return scene;
}

Frame renderAt(const Scene& scene, int rate) {
    ReferenceOptions options;
    options.rate = rate;
    options.memoryBytes = uint64_t(4) << 30;
    return ReferenceScene(scene, options).render();
}

struct Tally {
    size_t compared = 0, differing = 0, unmarked = 0, marked = 0;
    void add(bool differs, bool isMarked) {
        ++compared;
        differing += differs;
        unmarked += differs && !isMarked;
        marked += isMarked;
    }
};

void addCoverage(const Frame& coarse, const Frame& fine, Tally& tally) {
    const auto a = coarse.channel("id"), b = fine.channel("id"), marked = coarse.channel("uncertain");
    for (size_t i = 0; i < a.size(); ++i)
        tally.add(a[i] != b[i], marked[i] != 0);
}

/// Compares pixels where both frames certainly show the same object.
void addShadow(const Frame& coarse, const Frame& fine, const std::string& light, Tally& tally) {
    const auto a = coarse.channel(shadowChannel(light)), b = fine.channel(shadowChannel(light));
    const auto marked = coarse.channel(uncertainShadowChannel(light)), coverage = coarse.channel("uncertain");
    const auto idA = coarse.channel("id"), idB = fine.channel("id");
    for (size_t i = 0; i < a.size(); ++i)
        if (idA[i] != 0 && idA[i] == idB[i] && coverage[i] == 0) tally.add(a[i] != b[i], marked[i] != 0);
}

// One pixel in 10^5 may be unmarked: two contours that cross on the screen may open a gap together although
// neither alone changes the pixel.
constexpr double kUnmarkedShare = 1e-5;

TEST(Certificate, PixelsChangedByFinerRun_AreUncertain) {
    Tally coverage, shadow;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Scene scene = seededScene(seed);
        const Frame coarse = renderAt(scene, 8), fine = renderAt(scene, 128);
        Tally coverageHere, shadowHere;
        addCoverage(coarse, fine, coverageHere);
        for (const Light& light : scene.lights)
            addShadow(coarse, fine, light.name, shadowHere);
        fmt::print("seed {:2}: coverage {} differ, {} unmarked, {} marked; shadow {} differ, {} unmarked, {} "
                   "marked of {}\n",
                   seed, coverageHere.differing, coverageHere.unmarked, coverageHere.marked,
                   shadowHere.differing, shadowHere.unmarked, shadowHere.marked, shadowHere.compared);
        for (auto [total, here] : {std::pair(&coverage, &coverageHere), std::pair(&shadow, &shadowHere)}) {
            total->compared += here->compared;
            total->differing += here->differing;
            total->unmarked += here->unmarked;
            total->marked += here->marked;
        }
    }
    EXPECT_GT(coverage.differing, 1000u); // otherwise the test proves nothing
    EXPECT_GT(shadow.differing, 1000u);
    EXPECT_LE(double(coverage.unmarked), kUnmarkedShare * double(coverage.compared)) << coverage.unmarked;
    EXPECT_LE(double(shadow.unmarked), kUnmarkedShare * double(shadow.compared)) << shadow.unmarked;
    EXPECT_LT(coverage.marked, coverage.compared / 4); // marking everything must not pass
}

/// A flat sheet with rounded corners, lifted by 0.3, at the rates that the planner chooses: the interior of a
/// corner's face is flat, so that only its two sides on the boundary bow.
TEST(Certificate, RoundedSheet_IsWithinItsMarks) {
    Scene scene;
    scene.name = "sheet";
    scene.camera.width = kWidth;
    scene.camera.height = kHeight;
    scene.camera.fovYDegrees = 40;
    SceneObject sheet;
    sheet.name = "sheet";
    sheet.mesh = makePlane(2, 2, 3, 3);
    sheet.mesh.tags.boundaryCornersRound = true;
    sheet.relief = Relief{std::make_shared<HeightMap>(HeightMap::constant("top", 0)), 0.3, 0.3};
    scene.objects = {sheet};
    const float covered = 0.25f * kWidth * kHeight; // at least
    for (const double turn : {0.0, 90.0, 180.0, 270.0, 37.0}) {
        SCOPED_TRACE(turn);
        scene.objects[0].rotateDegrees = {0, turn, 0};
        scene.camera.positionWorld = {1.6, 1.6, 1.6};
        const Frame planned = ReferenceScene(scene, {}).render(), fine = renderAt(scene, 256);
        Tally coverage;
        addCoverage(planned, fine, coverage);
        EXPECT_EQ(coverage.unmarked, 0u) << coverage.differing << " differ";
        EXPECT_LE(coverage.marked, 30u);
        const auto a = fine.channel("A");
        EXPECT_GT(std::accumulate(a.begin(), a.end(), 0.0f), covered);
    }
}

} // namespace
} // namespace plumbline
