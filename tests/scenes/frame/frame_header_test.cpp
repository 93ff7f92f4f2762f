#include "scenes/core/error.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/header_fields.h"
#include "scenes/frame/object_info.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Relief reliefOf(Wrap wrapS, Wrap wrapT, double depth) {
    Relief relief;
    relief.map = std::make_shared<HeightMap>("map", 2, 3, std::vector<float>(6, 0.5f), wrapS, wrapT);
    relief.depth = depth;
    return relief;
}

/// Without a relief, with one along the normal, with one along an axis.
Scene threeObjects() {
    Scene scene;
    scene.name = "three";
    scene.hash = "0123456789abcdef";
    scene.changes = {"camera.width=20", "camera.height=10"};
    scene.camera.positionWorld = {0.1, 1.0 / 3.0, 3};
    scene.camera.fovYDegrees = 37.3;
    scene.camera.viewHeight = 2.0 / 3.0;
    scene.camera.width = 20;
    scene.camera.height = 10;
    scene.objects.resize(3);
    scene.objects[0].name = "floor";
    scene.objects[1].name = "torus with a name";
    scene.objects[1].relief = reliefOf(Wrap::Repeat, Wrap::Clamp, 0.07);
    scene.objects[2].name = "plane";
    scene.objects[2].relief = reliefOf(Wrap::Clamp, Wrap::Repeat, 1.0 / 7.0);
    scene.objects[2].relief->axisWorld = glm::normalize(Vec3(1, 2, -3));
    scene.lights.resize(2);
    scene.lights[0].name = "sun";
    scene.lights[0].toLightWorld = {0, 0.6, 0.8};
    scene.lights[1].name = "lamp";
    scene.lights[1].kind = Light::Kind::Point;
    scene.lights[1].positionWorld = {0.1, -1.0 / 3.0, 0};
    return scene;
}

Frame frameOf(const Scene& scene) {
    Frame frame(scene.camera.width, scene.camera.height);
    frame.metadata = sceneMetadata(scene);
    return frame;
}

TEST(FrameHeader, Scene_GivesTheseFields) {
    std::vector<std::string> fields;
    for (const auto& [field, value] : sceneMetadata(threeObjects()))
        fields.push_back(field);
    EXPECT_THAT(fields, ElementsAre("camera", "light.lamp", "light.sun", "lights", "object.1.name",
                                    "object.2.map_texels", "object.2.map_wrap", "object.2.name",
                                    "object.2.relief_depth", "object.3.map_texels", "object.3.map_wrap",
                                    "object.3.name", "object.3.relief_axis", "object.3.relief_depth",
                                    "program", "scene", "scene_changes", "scene_hash"));
}

TEST(FrameHeader, Texts_AreReadAsTheyStand) {
    const Frame frame = frameOf(threeObjects());
    EXPECT_TRUE(isPlumblines(frame));
    EXPECT_EQ(headerField(frame, header::kScene), "three");
    EXPECT_EQ(headerField(frame, header::kSceneHash), "0123456789abcdef");
    EXPECT_EQ(headerField(frame, header::kSceneChanges), "camera.width=20, camera.height=10");
    EXPECT_EQ(headerField(frame, header::kLights), "sun lamp");
    EXPECT_EQ(headerField(frame, header::kTechnique, "none"), "none");
    EXPECT_THAT(leftOutFields(frame, "a.exr"), IsEmpty());
}

TEST(FrameHeader, Objects_RoundTrip) {
    const Scene scene = threeObjects();
    const std::vector<ObjectInfo> written = objectsOf(scene),
                                  read = objectsFromHeader(frameOf(scene), "a.exr");
    EXPECT_TRUE(read == written); // numbers bit for bit
    ASSERT_EQ(read.size(), 3u);
    EXPECT_EQ(read[0].reliefDepth, 0);
    EXPECT_FALSE(read[0].map);
    EXPECT_EQ(read[1].id, 2);
    EXPECT_EQ(read[1].name, "torus with a name");
    EXPECT_EQ(read[1].reliefDepth, 0.07);
    EXPECT_FALSE(read[1].reliefAxisWorld);
    EXPECT_TRUE((read[1].map == ObjectInfo::Map{2, 3, true, false}));
    EXPECT_EQ(read[2].reliefAxisWorld, scene.objects[2].relief->axisWorld);
    EXPECT_TRUE((read[2].map == ObjectInfo::Map{2, 3, false, true}));
}

TEST(FrameHeader, Lights_RoundTrip) {
    const Scene scene = threeObjects();
    const auto lights = lightsFromHeader(frameOf(scene), "a.exr"); // by name
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0].name, "lamp");
    EXPECT_EQ(lights[0].kind, Light::Kind::Point);
    EXPECT_EQ(lights[0].positionWorld, scene.lights[1].positionWorld);
    EXPECT_EQ(lights[1].name, "sun");
    EXPECT_EQ(lights[1].kind, Light::Kind::Directional);
    EXPECT_NEAR(glm::length(lights[1].toLightWorld - scene.lights[0].toLightWorld), 0, 1e-15);
}

TEST(FrameHeader, UnreadableLights_AreLeftOutOrRefused) {
    EXPECT_THAT(lightsFromHeader(Frame(2, 1), "a.exr"), IsEmpty());
    for (const char* broken :
         {"", "to_light 1 2", "to_light 0 0 0", "up 1 2 3", "position 1 2 nan", "position 1 2 3 4"}) {
        Frame frame(2, 1);
        frame.metadata["light.sun"] = broken;
        EXPECT_THAT(lightsFromHeader(frame, "a.exr"), IsEmpty()); // somebody else's word
        frame.metadata["program"] = "plumbline 0.1.0";
        try {
            lightsFromHeader(frame, "a.exr");
            ADD_FAILURE() << broken;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("a.exr: header field 'light.sun'"));
        }
    }
}

TEST(FrameHeader, Camera_RoundTrips) {
    Scene scene = threeObjects();
    const Camera defaults;
    for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic}) {
        scene.camera.projection = projection;
        Camera expected = scene.camera; // with the opening that its projection has
        if (projection == Camera::Projection::Perspective)
            expected.viewHeight = defaults.viewHeight;
        else
            expected.fovYDegrees = defaults.fovYDegrees;
        EXPECT_EQ(cameraFromHeader(frameOf(scene), "a.exr"), expected);
    }
}

TEST(FrameHeader, ImportedFrame_HasNone) {
    Frame frame(1, 1);
    frame.metadata["object.color"] = "red";
    frame.metadata["object.x.relief_depth"] = "0.1";
    frame.metadata["object.2147483647.name"] = "a hash";
    frame.metadata["camera"] = "Cam01";
    EXPECT_THAT(objectsFromHeader(frame, "a.exr"), IsEmpty());
    EXPECT_FALSE(cameraFromHeader(frame, "a.exr"));
}

TEST(FrameHeader, UnreadableFieldsOfImportedFrame_AreLeftOut) {
    Frame frame(1, 1);
    frame.metadata = {{"object.1.name", "box"},
                      {"object.1.relief_depth", "0.1 m"},
                      {"object.1.map_texels", "big"},
                      {"object.1.relief_axis", "up"},
                      {"object.2.relief_depth", "0.2"}};
    const auto objects = objectsFromHeader(frame, "a.exr");
    ASSERT_EQ(objects.size(), 2u);
    EXPECT_EQ(objects[0].name, "box");
    EXPECT_FALSE(objects[0].reliefDepth); // not 0: that would be an object without a relief
    EXPECT_FALSE(objects[0].map);
    EXPECT_EQ(objects[1].reliefDepth, 0.2);
    EXPECT_THAT(leftOutFields(frame, "a.exr"),
                ElementsAre("object.1.map_texels", "object.1.relief_axis", "object.1.relief_depth"));
}

TEST(FrameHeader, UnreadableOwnFields_AreRefusedByName) {
    const auto message = [](const std::string& key, const std::string& value) -> std::string {
        Frame frame(1, 1);
        frame.metadata["program"] = "plumbline 0.1.0";
        frame.metadata[key] = value;
        try {
            (void)objectsFromHeader(frame, "a.exr");
            (void)cameraFromHeader(frame, "a.exr");
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(message("object.1.relief_depth", "deep"),
                HasSubstr("a.exr: header field 'object.1.relief_depth'"));
    for (const char* bad : {"-1", "nan", "inf", "", "0.1 0.2", "1e999"})
        EXPECT_THAT(message("object.1.relief_depth", bad), HasSubstr("can't be read")) << bad;
    for (const char* bad : {"0 5", "5", "1e9 5", "2.5 5", "5 5 5", "nan 5"})
        EXPECT_THAT(message("object.1.map_texels", bad), HasSubstr("can't be read")) << bad;
    EXPECT_THAT(message("object.1.map_wrap", "mirror repeat"), HasSubstr("can't be read"));
    for (const char* bad : {"", "0 1", "0 1 0 0", "0 nan 0", "up"})
        EXPECT_THAT(message("object.1.relief_axis", bad), HasSubstr("can't be read")) << bad;
    EXPECT_THAT(message("camera", "fisheye"), HasSubstr("header field 'camera'"));
    EXPECT_THAT(
        message("camera", "perspective position 0 0 0 target 0 0 1 up 0 1 0 fov_y_degrees nan size 1 1"),
        HasSubstr("can't be read"));
    // Numbers that no scene file could have: no direction, up along it, no opening, all there is, out of
    // range.
    for (const auto& [bad, field] :
         {std::pair("perspective position 0 0 1 target 0 0 1 up 0 1 0 fov_y_degrees 40 size 1 1",
                    "target is"),
          {"perspective position 0 0 0 target 0 2 0 up 0 1 0 fov_y_degrees 40 size 1 1", "up is parallel"},
          {"perspective position 0 0 0 target 0 0 1 up 0 0 0 fov_y_degrees 40 size 1 1", "up is zero"},
          {"perspective position 0 0 0 target 0 0 1 up 0 1 0 fov_y_degrees 0 size 1 1", "fov_y_degrees is 0"},
          {"perspective position 0 0 0 target 0 0 1 up 0 1 0 fov_y_degrees 180 size 1 1", "is 180"},
          {"perspective position 0 2e9 0 target 0 0 1 up 0 1 0 fov_y_degrees 40 size 1 1",
           "position is 2000000000"},
          {"orthographic position 0 0 0 target 0 0 1 up 0 1 0 view_height 0 size 1 1", "view_height is 0"},
          {"orthographic position 0 0 0 target 0 0 1 up 0 1 0 view_height 1e10 size 1 1",
           "view_height is 1"}})
        EXPECT_THAT(message("camera", bad),
                    AllOf(HasSubstr("a.exr: header field 'camera': "), HasSubstr(field)))
            << bad;
    EXPECT_THAT(message("camera", "orthographic position 0 0 0 target 0 0 1 up 0 1 0 view_height 2 size 2 1"),
                HasSubstr("is of a picture of 2 x 1 pixels, the frame has 1 x 1"));
}

TEST(FrameHeader, IgnoredFields_AreListed) {
    Frame frame(1, 1);
    frame.add("shadow.sun");
    frame.metadata = {{"camera", "Cam01"}, {"light.sun", "bright"}, {"light.fill", "no shadow of it"}};
    EXPECT_THAT(leftOutFields(frame, "a.exr"), ElementsAre("camera", "light.sun"));
    frame.metadata = {{"camera", "orthographic position 0 0 0 target 0 0 1 up 0 1 0 view_height 2 size 1 1"},
                      {"light.sun", "to_light 0 1 0"}};
    EXPECT_THAT(leftOutFields(frame, "a.exr"), IsEmpty());
}

} // namespace
} // namespace plumbline
