#include "tests/reference/exact/exact_scenes.h"

#include "scenes/maps/generate_map.h"
#include "scenes/mesh/shapes/shapes.h"
#include "tests/reference/test_scenes.h"

#include <ostream>

namespace plumbline {

namespace {

using MapPointer = std::shared_ptr<const HeightMap>;

constexpr int kWidth = 160, kHeight = 120; // pixels
constexpr int kFineRate = 1024;            // the finest rate: 3 to 24 segments per texel

MapPointer generated(const std::string& kind, int size, Wrap wrap = Wrap::Repeat) {
    return std::make_shared<HeightMap>(generateMap(kind, size, 3, wrap, wrap));
}

/// One texel of depth 0 in each 8 x 8 of depth 1, the thinnest possible feature.
MapPointer needles() {
    std::vector<float> depths(32 * 32, 1.0f);
    for (size_t j = 4; j < 32; j += 8)
        for (size_t i = 4; i < 32; i += 8)
            depths[32 * j + i] = 0;
    return std::make_shared<HeightMap>("needles", 32, 32, depths);
}

/// A perspective view at `degrees` from the normal, slightly rotated so that nothing is aligned with pixels;
/// the light is `lightDegrees` above the plane.
ExactScene sceneOf(std::string name, MapPointer map, double depth, Vec2 tile, double degrees,
                   double lightDegrees) {
    ExactScene result{std::move(name), squareScene(std::move(map), depth), kFineRate};
    Scene& scene = result.scene;
    scene.objects[0].relief->tile = tile;
    scene.camera.projection = Camera::Projection::Perspective;
    scene.camera.fovYDegrees = 40;
    scene.camera.width = kWidth;
    scene.camera.height = kHeight;
    const double angle = radians(degrees), turn = 0.3;
    scene.camera.targetWorld = {0.03, -0.02, -depth / 2};
    scene.camera.positionWorld =
        scene.camera.targetWorld +
        3.0 * Vec3(std::sin(angle) * std::sin(turn), -std::sin(angle) * std::cos(turn), std::cos(angle));
    const double elevation = radians(lightDegrees), around = 2.2;
    scene.lights[0].toLightWorld = {std::cos(elevation) * std::cos(around),
                                    std::cos(elevation) * std::sin(around), std::sin(elevation)};
    return result;
}

ExactScene orthographic(ExactScene scene, double viewHeight) {
    scene.scene.camera.projection = Camera::Projection::Orthographic;
    scene.scene.camera.viewHeight = viewHeight;
    return scene;
}

/// A camera between the pins at half their height, looking along the plane and slightly down.
ExactScene insideTheLayer() {
    ExactScene result = sceneOf("pins_from_inside", generated("pins", 64), 0.4, {1, 1}, 0, 35);
    Camera& camera = result.scene.camera;
    camera.positionWorld = {-0.5, -0.87, -0.21};
    camera.targetWorld = {0.1, 0.4, -0.24};
    camera.upWorld = {0, 0, 1};
    camera.fovYDegrees = 55;
    return result;
}

/// A rotated, translated and scaled plane with a smooth map that clamps.
ExactScene turnedShape() {
    ExactScene result =
        sceneOf("noise_on_a_turned_shape", generated("noise", 64, Wrap::Clamp), 0.2, {1.37, -1.37}, 30, 40);
    result.fineRate = kFineRate / 2; // because there are two segments along each side
    SceneObject& object = result.scene.objects[0];
    object.mesh = makePlane(2.2, 1.8, 2, 2);
    object.scheme = Scheme::CatmullClark;
    object.rotateDegrees = {70, 20, -35};
    object.scale = 0.9;
    object.translate = {0.1, -0.05, 0.02};
    object.relief->offset = 0.07;
    object.relief->uvOffset = {0.31, 0.77};
    return result;
}

} // namespace

void PrintTo(const ExactScene& scene, std::ostream* stream) {
    *stream << scene.name;
}

std::vector<ExactScene> exactScenes() {
    return {
        sceneOf("spikes", generated("pyramids", 64), 0.25, {1, 1}, 20, 40),
        sceneOf("spikes_grazed", generated("pyramids", 64), 0.25, {1, 1}, 80, 40),
        sceneOf("needles_grazed_1_37", needles(), 0.3, {1.37, 1.37}, 80, 30),
        sceneOf("pins_tile_8", generated("pins", 32), 0.1, {8, 8}, 55, 40),
        sceneOf("noise_1_37_grazed", generated("noise", 64), 0.2, {1.37, 1.37}, 80, 30),
        sceneOf("noise_1_37_grazing_light", generated("noise", 64), 0.15, {1.37, 1.37}, 30, 5),
        sceneOf("waves_tile_8_times_1_37_grazing_light", generated("waves", 32), 0.1, {-10.96, 10.96}, 40, 5),
        orthographic(sceneOf("fins_85_orthographic", generated("fins", 64), 0.2, {1.37, 1}, 85, 30), 1.2),
        orthographic(sceneOf("needles_orthographic", needles(), 0.2, {1.37, -2}, 60, 20), 2.0),
        sceneOf("noise_from_below", generated("noise", 64), 0.2, {1.37, 1.37}, 150, -25),
        insideTheLayer(),
        turnedShape(),
    };
}

} // namespace plumbline
