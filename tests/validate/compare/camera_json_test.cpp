#include "validate/compare/camera_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace plumbline {
namespace {

Scene describedScene() {
    Scene scene;
    scene.name = "a \"scene\"";
    scene.camera.positionWorld = {1, 2, 3};
    scene.camera.targetWorld = {0.5, 0, -1};
    scene.camera.fovYDegrees = 35;
    scene.camera.width = 320;
    scene.camera.height = 200;
    Light sun, lamp;
    sun.name = "sun";
    sun.toLightWorld = {0, 0.6, 0.8};
    lamp.name = "lamp";
    lamp.kind = Light::Kind::Point;
    lamp.positionWorld = {4, 5, 6};
    scene.lights = {sun, lamp};
    SceneObject floor;
    floor.name = "floor";
    scene.objects = {floor};
    return scene;
}

/// Uses only the numbers of the file and its conventions.
TEST(CameraJson, MatrixAndFov_ProjectAsCamera) {
    const Scene scene = describedScene();
    const auto json = nlohmann::json::parse(cameraJson(scene));
    const Vec4 world(0.3, 0.4, -0.5, 1);
    Vec3 view(0), back(0);
    const auto entry = [&](const char* matrix, int row, int column) {
        return json[matrix][size_t(row)][size_t(column)].get<double>();
    };
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            view[row] += entry("world_to_view", row, column) * world[column];
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            back[row] += entry("view_to_world", row, column) * Vec4(view, 1)[column];
    const double perPixel =
        2 * std::tan(radians(json["fov_y_degrees"].get<double>()) / 2) / json["height"].get<double>();
    const Vec3 expected = pixelFromWorld(scene.camera, Vec3(world));
    EXPECT_NEAR(0.5 * json["width"].get<double>() + view.x / -view.z / perPixel, expected.x, 1e-9);
    EXPECT_NEAR(0.5 * json["height"].get<double>() - view.y / -view.z / perPixel, expected.y, 1e-9);
    EXPECT_NEAR(-view.z, expected.z, 1e-12);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(back[axis], world[axis], 1e-12);
    EXPECT_EQ(json["projection"], "perspective");
    EXPECT_EQ(json["aspect"], 1.6);
    EXPECT_FALSE(json.contains("view_height"));
}

TEST(CameraJson, LightsObjectsOrthographic_AreWritten) {
    Scene scene = describedScene();
    scene.camera.projection = Camera::Projection::Orthographic;
    scene.camera.viewHeight = 2.5;
    const auto json = nlohmann::json::parse(cameraJson(scene));
    EXPECT_EQ(json["scene"], "a \"scene\"");
    EXPECT_EQ(json["projection"], "orthographic");
    EXPECT_EQ(json["view_height"], 2.5);
    EXPECT_FALSE(json.contains("fov_y_degrees"));
    EXPECT_EQ(json["lights"][0],
              nlohmann::json::parse(R"({"name":"sun","kind":"directional","to_light":[0.0,0.6,0.8]})"));
    EXPECT_EQ(json["lights"][1],
              nlohmann::json::parse(R"({"name":"lamp","kind":"point","position":[4.0,5.0,6.0]})"));
    EXPECT_EQ(json["objects"][0]["name"], "floor");
    EXPECT_EQ(json["objects"][0]["id"], 1);
    EXPECT_FALSE(json["objects"][0].contains("relief_depth"));
}

TEST(CameraJson, NonUtf8Names_AreWritten) {
    Scene scene = describedScene();
    scene.lights[0].name = "s\xffn";
    EXPECT_EQ(nlohmann::json::parse(cameraJson(scene))["lights"][0]["name"], "s\xef\xbf\xbdn");
}

} // namespace
} // namespace plumbline
