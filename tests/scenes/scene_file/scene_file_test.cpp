#include "scenes/frame/frame_header.h"
#include "scenes/scene_file/scene_library.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/scenes/scene_file/scene_file_fixture.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <random>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(SceneFile, EveryField_IsRead) {
    const Scene scene = read(kWholeScene);
    EXPECT_EQ(scene.name, "scene");
    EXPECT_EQ(scene.purpose, "A test");
    EXPECT_EQ(scene.background, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(scene.camera.positionWorld, Vec3(0, 1.2, 3));
    EXPECT_EQ(scene.camera.targetWorld, Vec3(0, 0.5, 0));
    EXPECT_EQ(scene.camera.upWorld, Vec3(0, 1, 0.5));
    EXPECT_EQ(scene.camera.fovYDegrees, 35);
    EXPECT_EQ(scene.camera.width, 64);
    EXPECT_EQ(scene.camera.height, 48);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].kind, Light::Kind::Directional);
    EXPECT_NEAR(glm::length(scene.lights[0].toLightWorld - Vec3(0, 0.6, 0.8)), 0, 1e-15); // 3-4-5, normalized
    EXPECT_EQ(scene.lights[1].name, "lamp");
    EXPECT_EQ(scene.lights[1].kind, Light::Kind::Point);
    EXPECT_EQ(scene.lights[1].positionWorld, Vec3(1, 2, 3));

    ASSERT_EQ(scene.objects.size(), 2u);
    const SceneObject& quad = scene.objects[0];
    EXPECT_EQ(quad.name, "quad");
    EXPECT_EQ(quad.scheme, Scheme::None);
    EXPECT_EQ(quad.proxyRate, 2);
    EXPECT_EQ(quad.translate, Vec3(1, 2, 3));
    EXPECT_EQ(quad.rotateDegrees, Vec3(10, 20, 30));
    EXPECT_EQ(quad.scale, 1.5);
    EXPECT_EQ(quad.mesh.faceCount(), 1);
    ASSERT_TRUE(quad.relief);
    EXPECT_EQ(quad.relief->depth, 0.08);
    EXPECT_EQ(quad.relief->offset, 0.01);
    EXPECT_EQ(quad.relief->tile, Vec2(8, -3));
    EXPECT_EQ(quad.relief->uvOffset, Vec2(0.5, 0.25));
    EXPECT_THAT(quad.relief->map->depths(), ElementsAre(1, 0.8f)); // stores heights 0 and 0.2
    EXPECT_EQ(quad.relief->map->wrapS(), Wrap::Repeat);
    EXPECT_EQ(quad.relief->map->wrapT(), Wrap::Clamp);
    ASSERT_TRUE(quad.colorMap);
    EXPECT_EQ(quad.colorMap->width, 2);

    const SceneObject& torus = scene.objects[1];
    EXPECT_EQ(torus.mesh.faceCount(), 12 * 6);
    EXPECT_EQ(torus.scheme, Scheme::CatmullClark);
    ASSERT_TRUE(torus.relief);
    EXPECT_EQ(torus.relief->map->depth({0.3, 0.7}), 0.5);
    EXPECT_EQ(torus.relief->tile, Vec2(1, 1));
    EXPECT_EQ(torus.color, Vec3(0.8, 0.75, 0.7));
}

TEST_F(SceneFile, MapByName_IsReadAlone) {
    read(kWholeScene); // writes it
    const auto stone = readSceneMap(folder_ / "scene.toml", "stone");
    EXPECT_THAT(stone->depths(), ElementsAre(1, 0.8f));
    EXPECT_EQ(stone->wrapT(), Wrap::Clamp);
    EXPECT_EQ(readSceneMap(folder_ / "scene.toml", "made")->width(), 16); // not used by any object
    EXPECT_THAT(
        inputErrorOf([&] { readSceneMap(folder_ / "scene.toml", "stoen"); }),
        HasSubstr("scene.toml: no height map of the scene is called \"stoen\"; expected made or stone; did "
                  "you mean 'stone'?"));
}

TEST_F(SceneFile, ShortestScene_HasDefaults) {
    const Scene scene = read("purpose = 'p'\n[camera]\nposition = [0, 0, 3]\n[[object]]\nname = 'o'\n"
                             "shape = { kind = 'sphere' }\n");
    EXPECT_EQ(scene.background, Vec3(0));
    EXPECT_EQ(scene.camera.targetWorld, Vec3(0));
    EXPECT_EQ(scene.camera.upWorld, Vec3(0, 1, 0));
    EXPECT_EQ(scene.camera.projection, Camera::Projection::Perspective);
    EXPECT_EQ(scene.camera.fovYDegrees, 40);
    EXPECT_EQ(scene.camera.width, 800);
    EXPECT_EQ(scene.camera.height, 600);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_FALSE(scene.objects[0].relief);
    EXPECT_EQ(scene.objects[0].proxyRate, 1);
    EXPECT_EQ(scene.objects[0].scale, 1);
    EXPECT_EQ(scene.objects[0].color, Vec3(0.8));
}

// The axis is the object's +z, rotated (10, 20, 30 degrees about x, y, z) but not scaled: cos 20 cos 10 along
// z.
TEST_F(SceneFile, Along_DefaultsToNormal) {
    EXPECT_FALSE(read(kWholeScene).objects[0].relief->axisWorld);
    EXPECT_FALSE(read(with("depth = 0.08", "depth = 0.08, along = \"normal\"")).objects[0].relief->axisWorld);
    const Scene scene = read(with("depth = 0.08", "depth = 0.08, along = \"axis\""));
    const std::optional<Vec3>& axis = scene.objects[0].relief->axisWorld;
    ASSERT_TRUE(axis);
    EXPECT_NEAR(axis->z, std::cos(radians(20.0)) * std::cos(radians(10.0)), 1e-15);
    EXPECT_NEAR(glm::length(*axis), 1, 1e-15);
    EXPECT_EQ(sceneMetadata(scene).at("object.1.relief_axis"),
              fmt::format("{} {} {}", axis->x, axis->y, axis->z));
    EXPECT_FALSE(sceneMetadata(scene).count("object.2.relief_axis"));
}

TEST_F(SceneFile, Requirements_KeepTheirLine) {
    EXPECT_TRUE(read(kWholeScene).requirements.empty());
    const Scene scene = read(std::string(kWholeScene) + R"(
[require]
"silhouette.iou" = ">= 0.99"
"depth.bias_relief" = [">= -0.01", "<= 0.01"]
)");
    ASSERT_EQ(scene.requirements.size(), 3u);
    EXPECT_EQ(scene.requirements[0].text, "depth.bias_relief >= -0.01");
    EXPECT_EQ(scene.requirements[1].text, "depth.bias_relief <= 0.01");
    EXPECT_EQ(scene.requirements[2].text, "silhouette.iou >= 0.99");
    EXPECT_THAT(scene.requirements[2].where, HasSubstr("require.silhouette.iou"));
    EXPECT_THAT(scene.requirements[2].where, HasSubstr("scene.toml:"));
    // Without quotes TOML parses it as a table.
    EXPECT_THAT(messageFor(std::string(kWholeScene) + "\n[require]\nsilhouette.iou = \">= 0.99\"\n"),
                HasSubstr("require.silhouette: is a table; expected a string or an array of strings"));
    EXPECT_THAT(messageFor(std::string(kWholeScene) + "\n[require]\n\"silhouette.iou\" = []\n"),
                HasSubstr("has no bound"));
    EXPECT_THAT(messageFor(std::string(kWholeScene) + "\n[require]\n\"silhouette.iou\" = 0.99\n"),
                HasSubstr("is 0.99; expected a string or an array of strings"));
}

TEST_F(SceneFile, Orthographic_IsRead) {
    const std::string text = with("fov_y_degrees = 35", "projection = \"orthographic\"\nview_height = 2.5");
    EXPECT_EQ(read(text).camera.projection, Camera::Projection::Orthographic);
    EXPECT_EQ(read(text).camera.viewHeight, 2.5);
}

TEST_F(SceneFile, EveryShapeAndMapKind_IsRead) {
    for (const char* shape :
         {"kind = 'plane', width = 3, depth = 2, segments = [4, 2]",
          "kind = 'quadric', a = 0.5, b = -0.25, half_size = 2", "kind = 'sphere', radius = 2, segments = 3",
          "kind = 'cylinder', radius = 1, height = 3, segments = [8, 2]", "kind = 'torus'",
          "kind = 'box', size = [1, 2, 3], segments = 2", "kind = 'teapot', segments = 2"})
        EXPECT_NO_THROW(read(with("kind = \"torus\", major = 1.0, minor = 0.25, segments = [12, 6]", shape)))
            << shape;
    for (const char* kind : {"cobbles", "bricks", "pyramids", "pins", "fins", "waves", "ramp", "noise"})
        EXPECT_NO_THROW(read(with("cobbles", kind))) << kind;
}

TEST_F(SceneFile, Faults_NameLineFieldAndHint) {
    struct Case {
        const char *from, *to, *message;
    };
    const Case cases[] = {
        {"purpose = \"A test\"\n", "", "scene.toml:1: purpose: is missing"},
        {"\"A test\"", "\" \"", "scene.toml:1: purpose: is empty"},
        {"background", "backgruond", "scene.toml:2: backgruond: unknown field"},
        {"background", "backgruond", "did you mean 'background'?"},
        {"[0.1, 0.2, 0.3]", "[0.1, 0.2, 1.5]",
         "scene.toml:2: background: is 1.5; expected a number from 0 to 1"},
        {"[camera]", "[kamera]", "camera: is missing"},
        {"position = [0, 1.2, 3]\n", "", "camera.position: is missing"},
        {"[0, 1.2, 3]", "[0, nan, 3]", "scene.toml:5: camera.position: is nan"},
        {"[0, 1.2, 3]", "[0, 0.5, 0]", "camera.target: is where the camera is"},
        {"up = [0, 1, 0.5]", "up = [0, 0, 0]", "scene.toml:7: camera.up: is zero"},
        {"up = [0, 1, 0.5]", "up = [0, -1.4, -6]", "camera.up: is parallel"}, // view is (0, -0.7, -3)
        {"35", "0", "camera.fov_y_degrees: is 0"},
        {"35", "180", "camera.fov_y_degrees: is 180"},
        {"fov_y_degrees = 35", "view_height = 2",
         "camera.view_height: belongs to projection \"orthographic\""},
        {"fov_y_degrees = 35", "projection = 'orthografic'", "did you mean 'orthographic'?"},
        {"width = 64", "width = 1e9", "camera.width: is 1"},
        {"width = 64", "width = 1000000000",
         "scene.toml:9: camera.width: is 1000000000; expected a whole number "
         "from 1 to 32768"},
        {"width = 64\nheight = 48", "width = 32768\nheight = 32768", "32768 x 32768 pixels are too many"},
        {"width = 64", "width = 0", "camera.width: is 0"},
        {"name = \"sun\"", "name = \"the sun\"",
         "light.name: is \"the sun\"; expected 1 to 64 of the letters"},
        {"name = \"sun\"", "name = \"a.b\"", "light.name: is \"a.b\""},
        {"name = \"sun\"", "name = \"../x\"", "light.name"},
        {"name = \"sun\"", "name = \"\"", "light.name: is \"\""},
        {"name = \"sun\"", "name = \"lamp\"", "light.name: \"lamp\" is taken already"},
        {"name = \"sun\"\n", "", "light.name: is missing"},
        {"to_light = [0, 3, 4]", "to_light = [0, 0, 0]", "scene.toml:14: light.to_light: is zero"},
        {"to_light = [0, 3, 4]", "",
         "scene.toml:12: light: has neither to_light nor position; expected to_light"},
        {"to_light = [0, 3, 4]", "to_light = [0, 3, 4]\nposition = [1, 1, 1]",
         "has both to_light and position"},
        {"stores = \"height\"\n", "", "height_map.stores: is missing; expected height or depth"},
        {"stores = \"height\"", "stores = \"hieght\"", "did you mean 'height'?"},
        {"[\"repeat\", \"clamp\"]", "[\"repeat\", \"clmap\"]", "did you mean 'clamp'?"},
        {"[\"repeat\", \"clamp\"]", "[\"repeat\"]", "height_map.wrap: has 1 entries"},
        {"[\"repeat\", \"clamp\"]", "\"repeat\"", "expected an array of strings"},
        {"file = \"maps/stone.png\"", "file = \"maps/stoen.png\"",
         "scene.toml:22: height_map.file: no such file as"},
        {"file = \"maps/stone.png\"", "file = \"quad.obj\"", "quad.obj: is not a picture"},
        {"file = \"maps/stone.png\"\n", "", "has neither file nor generate; expected file or generate"},
        {"kind = \"cobbles\"", "kind = \"cobles\"", "did you mean 'cobbles'?"},
        {"size = 16", "size = 0", "height_map.generate.size: is 0"},
        {"size = 16", "size = 100000", "height_map.generate.size: is 100000"},
        {"seed = 3", "seeed = 3", "height_map.generate.seeed: unknown field"},
        {"seed = 3 }", "seed = 3 }\nstores = \"height\"", "generated maps are depths"},
        {"name = \"quad\"", "name = \"torus\"", "object.name: \"torus\" is taken already"},
        {"mesh = \"quad.obj\"", "mesh = \"quat.obj\"", "scene.toml:32: object.mesh: no such file as"},
        {"mesh = \"quad.obj\"", "mesh = \"maps\"", "object.mesh:"},
        {"mesh = \"quad.obj\"", "mesh = \"maps\"", "maps: is not a file, it is a folder"},
        {"mesh = \"quad.obj\"", "", "object: has neither mesh nor shape; expected mesh or shape"},
        {"scheme = \"none\"", "scheme = \"catmull\"", "object.scheme: is the string \"catmull\""},
        {"scheme = \"none\"", "scheme = \"loop\"", "quad.obj:9: face 1: 4 vertices; expected only triangles"},
        {"proxy_rate = 2", "proxy_rate = 65",
         "object.proxy_rate: is 65; expected a whole number from 1 to 64"},
        {"proxy_rate = 2", "proxy_rate = 1.5", "object.proxy_rate: is 1.5"},
        {"proxy_rate = 2", "cull = \"front\"",
         "object.cull: is the string \"front\"; expected auto, back or none"},
        {"scale = 1.5", "scale = 0", "object.scale: is 0"},
        {"scale = 1.5", "scale = -1", "object.scale: is -1"},
        {"translate = [1, 2, 3]", "translate = [1, 2]", "object.translate: is an array of 2"},
        {"depth = 0.08", "depth = -0.08", "object.relief.depth: is -0.08"},
        {"depth = 0.08", "depth = inf", "object.relief.depth: is inf"},
        {"depth = 0.08, ", "", "object.relief.depth: is missing"},
        {"tile = [8, -3]", "tile = [8, 0]", "object.relief.tile: is [8, 0]; expected neither of them 0"},
        {"map = \"stone\"", "map = \"stoen\"",
         "object.relief.map: no height map is called \"stoen\"; expected made or "
         "stone; did you mean 'stone'?"},
        {"map = \"stone\"", "map = \"stone\", constant = 0.5", "has both map and constant"},
        {"depth = 0.08", "depth = 0.08, seams = \"wedl\"",
         "object.relief.seams: is the string \"wedl\"; expected weld or open; did you mean 'weld'?"},
        {"depth = 0.08", "depth = 0.08, along = \"axes\"",
         "object.relief.along: is the string \"axes\"; expected normal or axis; did you mean 'axis'?"},
        {"constant = 0.5, ", "", "object.relief: has neither map nor constant"},
        {"constant = 0.5", "constant = 1.5", "object.relief.constant: is 1.5"},
        {"constant = 0.5", "constant = 0.5, detph = 1", "object.relief.detph: unknown field"},
        {"color_map = \"maps/stone.png\"", "color_map = \"maps/stone.png\"\ncolor = [1, 1, 1]",
         "is given together with color"},
        {"color = [0.8, 0.75, 0.7]", "color = [8, 0.75, 0.7]", "object.color: is 8"},
        {"kind = \"torus\"", "kind = \"tours\"", "object.shape.kind: is the string \"tours\""},
        {"minor = 0.25", "minor = 0", "object.shape.minor: is 0"},
        {"minor = 0.25", "minro = 0.25", "object.shape.minro: unknown field"},
        {"minor = 0.25", "minor = 2", "object.shape: "}, // larger than the major radius
        {"segments = [12, 6]", "segments = [12, 0]", "object.shape.segments: is 0"},
        {"segments = [12, 6]", "segments = 12", "object.shape.segments: is 12"},
        {"[[object]]\nname = \"torus\"", "[object2]\nname = \"torus\"", "object2: unknown field"},
    };
    for (const Case& c : cases)
        EXPECT_THAT(messageFor(with(c.from, c.to)), HasSubstr(c.message)) << c.to;
}

TEST_F(SceneFile, NoSceneFile_IsRefused) {
    EXPECT_THAT(inputErrorOf([&] { readScene(folder_ / "none.toml"); }), HasSubstr("no such file"));
    EXPECT_THAT(inputErrorOf([&] { readScene(folder_.path()); }), HasSubstr("is not a file"));
    EXPECT_THAT(messageFor(""), HasSubstr("is empty"));
    EXPECT_THAT(messageFor("purpose = 'p'\n[camera]\nposition = [0, 0, 3]\n"),
                HasSubstr("at least one [[object]]"));
    EXPECT_THAT(messageFor("purpose = 'p'\nobject = 3\n[camera]\nposition = [0, 0, 3]\n"),
                HasSubstr("object: is 3"));
    EXPECT_THAT(messageFor(kQuad), HasSubstr("scene.toml:1: is not valid TOML"));
    std::string lights = kWholeScene;
    for (int i = 0; i < 15; ++i)
        lights += fmt::format("[[light]]\nname = \"l{}\"\nto_light = [0, 1, 0]\n", i);
    EXPECT_THAT(messageFor(lights), HasSubstr("is one of 17 lights; expected at most 16"));
}

TEST_F(SceneFile, ReliefOrColorMapWithoutUvs_IsRefused) {
    writeFile(folder_ / "quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    EXPECT_THAT(messageFor(kWholeScene), HasSubstr("object.relief: "));
    EXPECT_THAT(messageFor(kWholeScene), HasSubstr("quad.obj has no uvs; expected"));
    const std::string withoutRelief = with("relief = { map = \"stone\", depth = 0.08, offset = 0.01, tile = "
                                           "[8, -3], uv_offset = [0.5, 0.25] }\n",
                                           "");
    EXPECT_THAT(messageFor(withoutRelief), HasSubstr("object.color_map: "));
    EXPECT_NO_THROW(read(with("color_map = \"maps/stone.png\"\n", "", withoutRelief)));
    writeFile(folder_ / "quad.obj", std::string(kQuad) + "f 1 2 3\n");
    EXPECT_THAT(messageFor(kWholeScene), HasSubstr("has no uvs: the face in line 10 has no uv indices"));
}

TEST_F(SceneFile, PartialNormals_AreRefusedOnlyUnderNone) {
    writeFile(folder_ / "quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                                    "f 1/1/1 2/1/1 3/1/1\nf 1/1 3/1 4/1\n");
    EXPECT_THAT(messageFor(kWholeScene), HasSubstr("the face in line 8 has no normal indices"));
    EXPECT_NO_THROW(read(with("scheme = \"none\"", "scheme = \"catmull-clark\"")));
}

TEST_F(SceneFile, Hash_FollowsEveryRelevantByte) {
    const std::string hash = read(kWholeScene).hash;
    EXPECT_EQ(hash.size(), 32u);
    EXPECT_EQ(read(kWholeScene).hash, hash);
    EXPECT_NE(read(with("A test", "B test")).hash, hash);
    EXPECT_EQ(read(std::string(kWholeScene) + "\n# a comment\n").hash, hash);
    EXPECT_EQ(read(with("0.1", "1e-1")).hash, hash);
    EXPECT_EQ(read(with("width = 64\nheight = 48", "height = 48\nwidth = 64")).hash, hash);
    EXPECT_NE(read(with("0.1", "0.10000000000000002")).hash, hash); // the next double

    writePng(folder_ / "maps/stone.png", 2, 1, {0, 0, 0, 52, 52, 52});
    const std::string otherMap = read(kWholeScene).hash;
    EXPECT_NE(otherMap, hash);
    writeFile(folder_ / "quad.obj", std::string(kQuad) + "# a comment\n");
    EXPECT_NE(read(kWholeScene).hash, otherMap);
}

// Requirements don't change the rendering, so results remain comparable.
TEST_F(SceneFile, Hash_IgnoresRequirements) {
    const std::string hash = read(kWholeScene).hash, bound = "\"silhouette.iou\" = \">= 0.99\"";
    EXPECT_EQ(read(std::string(kWholeScene) + "[require]\n" + bound + "\n").hash, hash);
    EXPECT_EQ(read(std::string(kWholeScene) + "\n[ require ]\n" + bound + "\n").hash, hash);
    EXPECT_EQ(read("require = { " + bound + " }\n" + kWholeScene).hash, hash);
}

TEST_F(SceneFile, TruncatedAnywhere_IsReadOrRefused) {
    const std::string whole = kWholeScene;
    for (size_t length = 0; length < whole.size(); length += 3)
        worksOrIsRefused([&] { read(whole.substr(0, length)); });
}

TEST_F(SceneFile, DamagedAnywhere_IsReadOrRefused) {
    std::mt19937 random(17);
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
        std::string text = kWholeScene;
        // Digits aren't changed, because they might request a mesh of a million faces, which is valid but
        // slow.
        for (int k = 0; k < 2; ++k)
            text[random() % text.size()] = "[]{}=\"x,.\n#\xff"[random() % 12];
        refused += !worksOrIsRefused([&] { read(text); });
    }
    EXPECT_GT(refused, 200);
}

TEST(SceneLibrary, UnknownName_HasHint) {
    const std::vector<LibraryScene> scenes = libraryScenes();
    for (size_t i = 0; i < scenes.size(); ++i) {
        EXPECT_FALSE(scenes[i].purpose.empty());
        EXPECT_EQ(findScene(scenes[i].name), scenes[i].file);
        EXPECT_EQ(findScene(scenes[i].file.string()), scenes[i].file);
        EXPECT_TRUE(i == 0 || scenes[i - 1].name < scenes[i].name);
    }
    EXPECT_THAT(inputErrorOf([] { findScene("no/such.toml"); }), HasSubstr("no/such.toml: no such file"));
    EXPECT_THAT(inputErrorOf([] { findScene("nosuchscene"); }), HasSubstr("called 'nosuchscene'"));
    EXPECT_THAT(inputErrorOf([] { findScene("/"); }), HasSubstr("is not a file"));
    if (scenes.empty()) GTEST_SKIP() << "the library has no scenes yet";
    std::string misspelled = scenes[0].name;
    std::swap(misspelled[1], misspelled[2]);
    EXPECT_THAT(inputErrorOf([&] { findScene(misspelled); }),
                HasSubstr("did you mean '" + scenes[0].name + "'?"));
}

TEST(SceneLibrary, EveryScene_IsRead) {
    for (const LibraryScene& scene : libraryScenes())
        EXPECT_THAT(readScene(scene.file).warnings, testing::IsEmpty()) << scene.name;
}

} // namespace
} // namespace plumbline
