// Overrides of scene fields, and cameras given as an orbit.
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/scenes/scene_file/scene_file_fixture.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

class ChangedScene : public SceneFile {
  protected:
    Scene readChanged(const SceneChanges& changes) {
        writeFile(folder_ / "scene.toml", kWholeScene);
        return readScene(folder_ / "scene.toml", changes);
    }
    std::string messageOfChange(const std::string& change) {
        return inputErrorOf([&] { readChanged({change}); });
    }
};

TEST_F(ChangedScene, ChangedField_IsRead) {
    const Scene scene = readChanged(
        {"camera.width=300", "object.torus.relief.depth=0.25", "object.0.color_map=\"quad.obj\"",
         "object.quad.color_map=\"maps/stone.png\"", "light.lamp.position=[4, 5, 6]",
         "object.torus.proxy_rate=3", "background=[0, 0, 1]", "object.torus.shape={ kind = \"sphere\" }"});
    EXPECT_EQ(scene.camera.width, 300);
    EXPECT_EQ(scene.objects[1].relief->depth, 0.25);
    EXPECT_EQ(scene.objects[1].proxyRate, 3); // a field that isn't in the file
    EXPECT_EQ(scene.lights[1].positionWorld, Vec3(4, 5, 6));
    EXPECT_EQ(scene.background, Vec3(0, 0, 1));
    EXPECT_EQ(scene.objects[1].mesh.name, "sphere");
    EXPECT_EQ(scene.objects[0].colorMap->width, 2); // the later of two overrides applies
    EXPECT_EQ(scene.changes.size(), 8u);
}

TEST_F(ChangedScene, DifferentChanges_HaveDifferentHashes) {
    const std::string plain = readChanged({}).hash;
    EXPECT_EQ(plain, read(kWholeScene).hash);
    const std::string narrow = readChanged({"camera.width=300"}).hash;
    EXPECT_NE(narrow, plain);
    EXPECT_NE(narrow, readChanged({"camera.width=301"}).hash);
    EXPECT_EQ(narrow, readChanged({"camera.width=300"}).hash);
    EXPECT_EQ(narrow, read(with("width = 64", "width = 300")).hash); // the same scene
    EXPECT_EQ(plain, readChanged({R"(require={"silhouette.iou" = ">= 0.99"})"}).hash);
    EXPECT_EQ(readChanged({"camera.fov_y_degrees=50"}).hash, readChanged({"camera.fov_y_degrees=50.0"}).hash);
    EXPECT_EQ(readChanged({"camera.target=[0, 0.0, 0]"}).hash,
              readChanged({"camera.target=[-0.0, 0, 0]"}).hash);
    EXPECT_NE(readChanged({"camera.target=[0, 1, 0]"}).hash, readChanged({"camera.target=[1, 0, 0]"}).hash);
    EXPECT_NE(readChanged({"purpose=\"1\""}).hash,
              readChanged({"purpose=\"1.0\""}).hash); // strings aren't parsed as numbers
}

TEST_F(ChangedScene, FaultyChange_IsNamedInError) {
    EXPECT_EQ(messageOfChange("camera.width"),
              "--scene-set camera.width: has no '='; expected PATH=VALUE, for example camera.width=400");
    EXPECT_EQ(messageOfChange("camera.width=-1"),
              "--scene-set camera.width=-1: is -1; expected a whole number from 1 to 32768");
    EXPECT_EQ(messageOfChange("camera.widht=30"),
              "--scene-set camera.widht=30: unknown field; expected fov_y_degrees, height, orbit, "
              "position, projection, target, up, view_height or width; did you mean 'width'?");
    EXPECT_EQ(messageOfChange("camra.width=30"), "--scene-set camra.width=30: there is no table 'camra'; "
                                                 "expected camera, height_map, light or object; did you mean "
                                                 "'camera'?");
    EXPECT_EQ(messageOfChange("object.tours.scale=2"),
              "--scene-set object.tours.scale=2: no object is called 'tours'; expected quad or torus; did "
              "you mean 'torus'?");
    EXPECT_EQ(messageOfChange("object.torus=2"),
              "--scene-set object.torus=2: 'object' is an array of 2; expected object.NAME.FIELD=VALUE");
    EXPECT_THAT(inputErrorOf([&] {
                    readChanged({"light=[{ name = \"a\" }, 3]", "light.b.name=\"c\""});
                }),
                testing::HasSubstr("'light' is an array of 2; expected"));
    EXPECT_EQ(messageOfChange("purpose.a.b=2"),
              "--scene-set purpose.a.b=2: 'purpose' is the string \"A test\"; expected a table");
    EXPECT_EQ(messageOfChange("camera.=2"),
              "--scene-set camera.=2: names no field; expected TABLE.FIELD=VALUE");
    EXPECT_EQ(messageOfChange("camera.width=1\nheight=2"),
              "--scene-set camera.width=1 height=2: '1 height=2' is more than a value");
    EXPECT_THAT(messageOfChange("camera.width=wide"), testing::HasSubstr("'wide' is not a TOML value"));
    // Inside an inserted table, the location of the field itself.
    EXPECT_EQ(messageOfChange("object.torus.shape={ kind = \"sphere\", radius = -1 }"),
              "--scene-set object.torus.shape={ kind = \"sphere\", radius = -1 }:1: "
              "object.torus.shape.radius: is -1; expected a "
              "number from 1e-09 to 1000000000");
}

const char* const kPlace = "position = [0, 1.2, 3]\ntarget = [0, 0.5, 0]\nup = [0, 1, 0.5]\n";

TEST_F(SceneFile, Orbit_PlacesCameraAroundTarget) {
    const auto camera = [&](const std::string& orbit) {
        return read(with(kPlace, "target = [1, 0.5, 0]\norbit = " + orbit + "\n")).camera;
    };
    const auto expectNear = [](const Vec3& found,
                               const Vec3& expected) { // a few rounding errors of numbers up to 3
        EXPECT_LT(glm::length(found - expected), 1e-14) << found.x << " " << found.y << " " << found.z;
    };
    const Camera level = camera("{ distance = 2, polar_degrees = 90 }");
    expectNear(level.positionWorld, Vec3(1, 0.5, 2));
    expectNear(level.upWorld, Vec3(0, 1, 0));
    const Camera side = camera("{ distance = 2, polar_degrees = 90, azimuth_degrees = 90 }");
    expectNear(side.positionWorld, Vec3(3, 0.5, 0));
    // From straight above, the azimuth direction is at the bottom of the image.
    const Camera above = camera("{ distance = 2, polar_degrees = 0 }");
    expectNear(above.positionWorld, Vec3(1, 2.5, 0));
    expectNear(above.upWorld, Vec3(0, 0, -1));
    const Camera slanted = camera("{ distance = 2, polar_degrees = 60 }");
    expectNear(slanted.positionWorld, Vec3(1, 0.5 + 1, std::sqrt(3.0)));
    EXPECT_NEAR(glm::dot(slanted.upWorld, slanted.positionWorld - slanted.targetWorld), 0, 1e-14);
}

TEST_F(SceneFile, OrbitWithPosition_IsRefused) {
    EXPECT_EQ(messageFor(with("up = [0, 1, 0.5]", "orbit = { distance = 2, polar_degrees = 10 }")),
              "scene.toml:5: camera.position: is given together with orbit; expected one of the two");
    EXPECT_EQ(messageFor(with(kPlace, "target = [0, 1, 0]\norbit = { distance = 1e9, polar_degrees = 0 }\n")),
              "scene.toml:6: camera.orbit: gives an invalid camera position: it is 1000000001; expected "
              "-1000000000 to 1000000000");
    EXPECT_EQ(messageFor(with(kPlace, "orbit = { distance = 2, polar_degrees = 200 }\n")),
              "scene.toml:5: camera.orbit.polar_degrees: is 200; expected a number from 0 to 180");
}

} // namespace
} // namespace plumbline
