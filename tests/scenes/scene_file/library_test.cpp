// The scenes of the library: they load, and their objects are visible and have a reasonable size.
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "scenes/surface/base_surface.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

std::vector<std::string> libraryNames() {
    std::vector<std::string> names;
    for (const LibraryScene& scene : libraryScenes())
        names.push_back(scene.name);
    return names;
}

Bounds boundsWorld(const SceneObject& object) {
    Bounds bounds;
    for (const Vec3& point : object.meshWorld().points)
        bounds.add(point);
    return bounds;
}

TEST(Library, RequiredScenes_ArePresent) {
    EXPECT_THAT(libraryNames(),
                testing::IsSupersetOf({"stone_torus", "small_torus", "brick_cylinder", "pyramid_plane",
                                       "cobble_sphere", "teapot", "room", "relief_room_shadows"}));
}

class LibraryScenes : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, LibraryScenes, testing::ValuesIn(libraryNames()),
                         [](const auto& scene) { return scene.param; });

TEST_P(LibraryScenes, EveryScene_ShowsItsObjects) {
    const Scene scene = readScene(findScene(GetParam()));
    EXPECT_GT(scene.purpose.size(), 20u);
    EXPECT_FALSE(scene.lights.empty());
    for (const SceneObject& object : scene.objects) {
        SCOPED_TRACE(object.name);
        const Bounds bounds = boundsWorld(object);
        EXPECT_GT(bounds.diagonal(), 0.5);
        EXPECT_LT(bounds.diagonal(), 20);
        const Vec3 camera = scene.camera.positionWorld;
        const bool cameraInside =
            glm::all(glm::greaterThan(camera, bounds.low)) && glm::all(glm::lessThan(camera, bounds.high));
        EXPECT_FALSE(cameraInside);
        // Some point of the limit surface is in the image, with a margin of a tenth of the image on each
        // side.
        int inside = 0;
        const BaseSurface surface(object.meshWorld(), object.scheme);
        BaseSurface::Evaluator evaluator(surface);
        for (int patch = 0; patch < static_cast<int>(surface.patches().size()); ++patch) {
            evaluator.setPatch(patch);
            for (const double u : {0.0, 0.25, 0.5, 0.75})
                for (const double v : {0.0, 0.25, 0.5, 0.75}) {
                    const Vec3 pixel = pixelFromWorld(scene.camera, evaluator.point(u, v).position);
                    const Vec2 place = Vec2(pixel) / Vec2(scene.camera.width, scene.camera.height);
                    if (pixel.z > 0 && place.x > 0.1 && place.x < 0.9 && place.y > 0.1 && place.y < 0.9)
                        ++inside;
                }
        }
        EXPECT_GT(inside, 0);
        if (object.relief) {
            // Deeper than a pixel, but shallow enough not to reach the far side.
            EXPECT_GT(object.relief->depth, 0.005 * bounds.diagonal());
            EXPECT_LT(object.relief->depth, 0.1 * bounds.diagonal());
        }
    }
}

TEST_P(LibraryScenes, EveryScene_MapsAreSeamlessOnObjects) {
    // Where u wraps around, the tile count must be an integer, or the map is discontinuous there. Planes and
    // boxes are open; on a cylinder only u wraps around.
    const Scene scene = readScene(findScene(GetParam()));
    for (const SceneObject& object : scene.objects) {
        if (!object.relief || object.mesh.name == "plane" || object.mesh.name == "box") continue;
        SCOPED_TRACE(object.name);
        const Vec2 tile = object.relief->tile;
        EXPECT_EQ(tile.x, std::round(tile.x));
        if (object.mesh.name != "cylinder") {
            EXPECT_EQ(tile.y, std::round(tile.y));
        }
    }
}

} // namespace
} // namespace plumbline
