// Searches in whole frames: unusual scales, all angles, curved bases, shadows.
#include "tests/realtime/draw/search_rays.h"

#include <cstring>

namespace plumbline {
namespace {

// --- frames --------------------------------------------------------------------------------------

/// In the xy plane, `angle` from the normal of the square: rays go down and toward +x, turned about +y by
/// `turn`.
Camera fromTheSide(double angleDegrees, double turnDegrees, double viewHeight, int pixels) {
    const double angle = radians(angleDegrees), turn = radians(turnDegrees);
    const Vec3 up = angleDegrees > 89.99 ? Vec3(0, 1, 0) : Vec3(std::sin(turn), 0, -std::cos(turn));
    return orthographicCamera(
        5.0 * Vec3(-std::sin(angle) * std::cos(turn), std::cos(angle), -std::sin(angle) * std::sin(turn)), up,
        viewHeight, pixels);
}

/// The ray of a pixel over squareObject(side, …, depth) in relief space.
ReliefLine lineOf(const Ray& ray, const SceneObject& square, double side) {
    const Vec3 entry = ray.at(-ray.origin.y / ray.direction.y);
    const Vec3 travel = ray.direction * (square.relief->depth / -ray.direction.y);
    const Vec2 st = square.relief->tile * Vec2(entry.x / side + 0.5, 0.5 - entry.z / side);
    return {st, square.relief->tile * Vec2(travel.x, -travel.z) / side};
}

TEST(SearchFrames, OddScales_ShowRelief) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Non-square tiles of a non-square map, with two depths. A linear step is 1/128 of the depth, so the hit
    // is at most that much too deep, except for missed features.
    const auto waves = std::make_shared<HeightMap>(generated("waves", 64));
    const auto texels = std::make_shared<HeightMap>(randomMap(8, 4, Wrap::Repeat, Wrap::Repeat));
    for (const auto& map : {waves, texels})
        for (const double depth : {0.1, 0.7}) {
            SceneObject square = squareObject(4, map, depth);
            square.relief->tile = Vec2(3, 1);
            const Camera camera = fromTheSide(50, 25, 1, 48);
            const CameraRays rays(camera);
            const Scene scene = sceneOf(square, camera);
            for (const auto& [technique, tolerance] :
                 {std::pair("exact_cells", 1e-5),
                  {"linear:linear_steps=128", 1.0 / 128 + 1e-5},
                  {"linear_binary:linear_steps=128,binary_steps=16", 2e-5},
                  {"linear_secant1:linear_steps=128", 0.5 / 128},
                  {"linear_secant:linear_steps=128,tolerance=0.00001,max_iterations=30", 1e-4}}) {
                const Frame frame = draw(scene, technique);
                ASSERT_EQ(coveredPixels(frame), frame.pixelCount());
                size_t wrong = 0;
                for (int y = 0; y < 48; ++y)
                    for (int x = 0; x < 48; ++x) {
                        const size_t pixel = pixelAt(frame, x, y);
                        const ReliefLine line = lineOf(rays.ray(x + 0.5, y + 0.5), square, 4);
                        const double truth = trueFirstHit(*map, line).hit->t;
                        wrong += !(std::abs(-vectorAt(frame, "P", pixel).y / depth - truth) <= tolerance);
                    }
                EXPECT_LE(wrong, frame.pixelCount() / 100)
                    << technique << " depth " << depth << " " << map->name();
            }
        }
}

TEST(SearchFrames, EveryAngle_GivesFiniteValues) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // From perpendicular (E4: a slope would be infinite) to grazing views; draw() checks for NaN. On a flat
    // base every ray hits.
    const auto map = std::make_shared<HeightMap>(randomMap(7, 5, Wrap::Repeat, Wrap::Repeat));
    for (const double angle : {0.0, 45.0, 89.0, 89.9, 89.995, 90.0}) {
        const Scene scene = sceneOf(squareObject(2, map, 0.3), fromTheSide(angle, 20, 2.2, 24));
        const size_t polygon = coveredPixels(draw(scene, "normal_mapping"));
        for (const std::string& search : kSearches) {
            EXPECT_EQ(coveredPixels(draw(scene, search)), polygon) << search << " " << angle;
            EXPECT_LE(coveredPixels(draw(scene, search + "@quadric")), polygon) << search << " " << angle;
        }
        for (const std::string& search : kParallax)
            EXPECT_EQ(coveredPixels(draw(scene, search)), polygon) << search << " " << angle;
    }
}

TEST(SearchFrames, CurvedBases_GiveFiniteValues) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    SceneObject torus;
    torus.name = "torus";
    torus.mesh = makeTorus(1, 0.4, 12, 8);
    torus.relief = Relief{std::make_shared<HeightMap>(randomMap(7, 5, Wrap::Repeat, Wrap::Repeat)), 0.1, 0,
                          Vec2(6, 4), Vec2(0)};
    Scene scene = sceneOf(torus, Camera());
    scene.camera.positionWorld = Vec3(0.5, 1.5, 4);
    scene.camera.width = scene.camera.height = 64;
    const size_t polygons = coveredPixels(draw(scene, "normal_mapping"));
    const size_t exact = coveredPixels(draw(scene, "exact_cells@quadric"));
    EXPECT_LT(exact, polygons);
    for (const std::string& search : kSearches) {
        EXPECT_EQ(coveredPixels(draw(scene, search)), polygons) << search;
        // Every hit of a coarse search is inside the relief, so the exact search has a hit too.
        EXPECT_LE(coveredPixels(draw(scene, search + "@quadric")), exact) << search;
    }
    EXPECT_GE(coveredPixels(draw(scene, "linear@quadric:linear_steps=500")), exact * 99 / 100);
}

void expectSameButForCost(const Frame& a, const Frame& b) {
    ASSERT_EQ(a.channelNames(), b.channelNames());
    for (const std::string& name : a.channelNames()) {
        const auto one = a.channel(name), other = b.channel(name);
        if (name.starts_with("cost.")) continue;
        EXPECT_EQ(std::memcmp(one.data(), other.data(), a.pixelCount() * sizeof(float)), 0) << name;
    }
}

TEST(ParallaxFrames, ZeroDepth_EqualsNormalMapping) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto map = std::make_shared<HeightMap>(randomMap(7, 5, Wrap::Repeat, Wrap::Repeat));
    for (const double angle : {0.0, 60.0, 89.0}) {
        const Scene scene = sceneOf(squareObject(2, map, 0.3), fromTheSide(angle, 20, 1, 32));
        for (const std::string& search : kParallax)
            expectSameButForCost(draw(scene, search + ":scale=0"), draw(scene, "normal_mapping"));
    }
}

TEST(ParallaxFrames, Offsets_AreTangentAndSine) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A floor at depth 0.5 of 0.2 seen at 60 degrees: 0.1 tan 60 to the side, as on the plane itself;
    // limited, 0.1 sin 60, half of it (E9). s = (x + 1) / 2.
    const auto map = std::make_shared<HeightMap>(HeightMap::constant("constant", 0.5f));
    const Camera camera = fromTheSide(60, 0, 0.8, 16);
    const Scene scene = sceneOf(squareObject(2, map, 0.2), camera);
    const Ray ray = CameraRays(camera).ray(5.5, 7.5);
    const double entry = ray.at(-ray.origin.y / ray.direction.y).x;
    for (const auto& [technique, offset] : {std::pair("parallax", 0.1 * std::tan(radians(60.0))),
                                            {"parallax_offset_limited", 0.1 * std::sin(radians(60.0))},
                                            {"parallax:bias=-0.5", 0.0},
                                            {"parallax:scale=0.5", 0.05 * std::tan(radians(60.0))}}) {
        const Frame frame = draw(scene, technique);
        EXPECT_NEAR(stAt(frame, pixelAt(frame, 5, 7)).x, (entry + offset + 1) / 2, 1e-6) << technique;
    }
}

TEST(SearchFrames, ExactCells_CastsExactShadows) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A wall 0.2 high at x = 0 lit at 45 degrees shadows the floor up to x = 0.2; a fin one texel wide at x =
    // -0.6, which ten steps miss, up to x = -0.4. A texel is 2 / 512 wide, a pixel 0.8 / 256.
    std::vector<float> depths(512, 1);
    depths[102] = 0; // center x = 102.5 / 256 - 1 = -0.5996
    Scene scene = sceneOf(squareObject(2, std::make_shared<HeightMap>(profile(depths, Wrap::Clamp)), 0.2),
                          orthographicCamera({-0.4, 5, 0}, {0, 0, -1}, 0.8, 256));
    scene.camera.targetWorld = Vec3(-0.4, 0, 0);
    scene.lights = {directionalLight("left", {-1, 1, 0})};
    const Frame frame = draw(scene, "exact_cells");
    const auto shadow = frame.channel("shadow.left");
    double begin = 1, end = -1;
    for (int x = 0; x < 256; ++x) {
        const double xWorld = (x + 0.5) / 256 * 0.8 - 0.8;
        if (shadow[pixelAt(frame, x, 50)] != 1) continue;
        begin = std::min(begin, xWorld);
        end = std::max(end, xWorld);
    }
    // From the fin's far side to where the ray over its top hits the floor.
    EXPECT_NEAR(begin, -0.6, 0.0039 + 0.0031);
    EXPECT_NEAR(end, -0.4, 0.0039 + 0.0031);
}

} // namespace
} // namespace plumbline
