// Compares shadows from shadow maps with shadows derived by hand.
#include "realtime/draw/baked_input.h"
#include "realtime/draw/shadow_maps.h"
#include "realtime/draw/technique_program.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/free_memory.h"
#include "tests/realtime/draw/shadow_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace plumbline {
namespace {

constexpr int kPixels = 256;
const std::string kMap = "linear_binary:shadow=map";

std::shared_ptr<const HeightMap> constantMap(float depth) {
    return std::make_shared<HeightMap>(HeightMap::constant("constant", depth));
}

Camera fromAbove(double viewHeight) {
    return orthographicCamera({0, 5, 0}, {0, 0, -1}, viewHeight, kPixels);
}

// --- where a shadow falls ------------------------------------------------------------------------

TEST(ShadowMap, Sun_CastsPoleShadowOfFormula) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A pole 0.1 thick and 1 tall on a plain floor, the sun at 45 degrees from +x: a point at height y
    // shadows the floor at x - y. A receiver uses a texel whose center is up to half of its diagonal away,
    // orthogonal to the rays, which is sqrt(2) times that along the floor. Near the pole's foot the bias
    // causes light leaks: occluders closer than h (1 + tan 45) along the ray are ignored, which applies to
    // the pole for x > -0.05 - 2 h / sqrt(2).
    const Scene scene =
        sceneOfObjects({plateObject("floor", 4, 0), boxObject("pole", {0.1, 1, 0.1}, {0, 0.5, 0})},
                       {directionalLight("sun", {1, 1, 0})}, fromAbove(3));
    Bounds bounds;
    bounds.add({-2, 0, -2});
    bounds.add({2, 1, 2});
    for (const int size : {256, 1024}) {
        const double h = shadowProjections(scene.lights, bounds, Vec3(0), size)[0].halfDiagonal;
        const Frame frame = draw(scene, kMap + ",shadow_map_size=" + std::to_string(size));
        const size_t decided = expectShadows(frame, "sun", 1, [&](const Vec3& p) {
            if (p.x > -0.05 - 2 * h / std::numbers::sqrt2 && std::abs(p.z) < 0.05) return Expected::Either;
            return inRectangle(p.x, p.z, {-1.05, -0.05}, {0.05, 0.05}, std::numbers::sqrt2 * h);
        });
        EXPECT_GT(decided, size_t(kPixels * kPixels * 95 / 100)) << size;
        EXPECT_GT(countShadows(frame, "sun", 1).shadowed, 300u) << size;
    }
}

TEST(ShadowMap, Lamp_CastsPoleShadowOfFormula) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The same pole under a lamp at (1, 2, 0): a point at height y shadows the floor at the lamp + (point -
    // lamp) 2 / (2 - y). Its base stays, its top's square is projected to x in [-1.1, -0.9], |z| < 0.1; the
    // shadow is the convex hull of both. A receiver's texel is up to h = sqrt(2) / size times the distance
    // along the face's axis away, at most 2.1 to 4.2 here, and farther along the floor for oblique rays, with
    // cosines of at least 2 / 3.6.
    const Scene scene =
        sceneOfObjects({plateObject("floor", 4, 0), boxObject("pole", {0.1, 1, 0.1}, {0, 0.5, 0})},
                       {pointLight("lamp", {1, 2, 0})}, fromAbove(3));
    const double h = std::numbers::sqrt2 / 1024, edge = h * 2.6 * 3.6 / 2;
    const Frame frame = draw(scene, kMap);
    const size_t decided = expectShadows(frame, "lamp", 1, [&](const Vec3& p) {
        // The hull's side from (0.05, 0.05) to (-0.9, 0.1).
        const double side = 0.05 + 0.05 * (0.05 - p.x) / 0.95;
        const double outside = std::max({p.x - 0.05, -1.1 - p.x, std::abs(p.z) - (p.x < -0.9 ? 0.1 : side)});
        const bool foot = std::abs(p.x) < 0.05 + 4 * edge &&
                          std::abs(p.z) < 0.05 + edge; // light leak due to the bias, as above
        if (foot || std::abs(outside) < edge) return Expected::Either;
        return outside > 0 ? Expected::Lit : Expected::Shadow;
    });
    EXPECT_GT(decided, size_t(kPixels * kPixels * 95 / 100));
    EXPECT_GT(countShadows(frame, "lamp", 1).shadowed, 500u);
}

TEST(ShadowMap, PlainObject_ShadowsReliefAtHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A plate 0.4 wide at y = 0.4 over a relief floor 0.1 below its polygon; the sun at 45 degrees. The
    // shadow moves by 0.5 to x in [-0.7, -0.3]; with lookups from the polygon it would move by 0.4.
    const Scene scene =
        sceneOfObjects({plateObject("floor", 4, 0, constantMap(0.5f), 0.2), plateObject("plate", 0.4, 0.4)},
                       {directionalLight("sun", {1, 1, 0})}, fromAbove(3));
    const Frame frame = draw(scene, kMap);
    const size_t decided = expectShadows(frame, "sun", 1, [](const Vec3& p) {
        return inRectangle(p.x, p.z, {-0.7, -0.2}, {-0.3, 0.2}, 0.01);
    });
    EXPECT_GT(decided, size_t(kPixels * kPixels * 9 / 10));
    EXPECT_GT(countShadows(frame, "sun", 1).shadowed, 500u);
    // The depth correction has no effect on it.
    const Frame uncorrected = draw(scene, kMap + ",depth_correction=false");
    for (size_t i = 0; i < frame.pixelCount(); ++i)
        ASSERT_EQ(frame.channel("shadow.sun")[i], uncorrected.channel("shadow.sun")[i]);
}

TEST(ShadowMap, Relief_ShadowsBehindItsHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A relief plate 0.4 wide, its polygon at y = 0.7, its surface at 0.5. The light's rays through the
    // polygon hit a plain plate at height y around (-0.7 + y, 0): at 0.6 before the relief stops them, at 0.3
    // behind it.
    for (const double height : {0.6, 0.3}) {
        const Scene scene = sceneOfObjects(
            {plateObject("relief", 0.4, 0.7, constantMap(1), 0.2), plateObject("plain", 2, height)},
            {directionalLight("sun", {1, 1, 0})}, fromAbove(2));
        const double shift = height - 0.7;
        const Frame frame = draw(scene, kMap);
        const size_t decided = expectShadows(frame, "sun", 2, [&](const Vec3& p) {
            if (height > 0.5) return Expected::Lit;
            return inRectangle(p.x, p.z, {shift - 0.2, -0.2}, {shift + 0.2, 0.2}, 0.01);
        });
        EXPECT_GT(decided, size_t(kPixels * kPixels * 9 / 10)) << height;
        EXPECT_EQ(countShadows(frame, "sun", 2).shadowed > 1000, height < 0.5) << height;
    }
}

TEST(ShadowMap, Relief_ShadowsRelief) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Polygons at y = 0.5 and 0, surfaces at 0.4 and -0.1: the plate's shadow, 0.4 wide, is 0.6 farther.
    const Scene scene = sceneOfObjects({plateObject("floor", 4, 0, constantMap(0.5f), 0.2),
                                        plateObject("plate", 0.4, 0.5, constantMap(0.5f), 0.2)},
                                       {directionalLight("sun", {1, 1, 0})}, fromAbove(3));
    const Frame frame = draw(scene, kMap);
    const size_t decided = expectShadows(frame, "sun", 1, [](const Vec3& p) {
        return inRectangle(p.x, p.z, {-0.8, -0.2}, {-0.4, 0.2}, 0.01);
    });
    EXPECT_GT(decided, size_t(kPixels * kPixels * 9 / 10));
    EXPECT_GT(countShadows(frame, "sun", 1).shadowed, 500u);
}

TEST(ShadowMap, PlainSheetsAndReliefs_CastFromTheirBacks) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Plates 0.4 wide at y = 0.4, flipped so that their back faces are toward the sun. A relief casts where
    // its polygons do.
    for (const bool relief : {false, true}) {
        SceneObject plate = plateObject("plate", 0.4, 0.4, relief ? constantMap(0.5f) : nullptr, 0.1);
        plate.rotateDegrees = Vec3(180, 0, 0);
        const Scene scene = sceneOfObjects({plateObject("floor", 4, 0, constantMap(0.5f), 0.2), plate},
                                           {directionalLight("sun", {1, 1, 0})}, fromAbove(3));
        const size_t decided = expectShadows(draw(scene, kMap), "sun", 1, [&](const Vec3& p) {
            return inRectangle(p.x, p.z, {-0.7, -0.2}, {-0.3, 0.2}, 0.01);
        });
        EXPECT_GT(decided, size_t(kPixels * kPixels * 9 / 10)) << relief;
    }
}

// --- no shadow where nothing stands --------------------------------------------------------------

TEST(ShadowMap, BiasOnPlanes_PreventsSelfShadowing) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A plain square, lights from head-on to 86 degrees from its normal; coarse and fine maps. The derivation
    // is valid for every texel: where N.L is at least 0.05, up to which the bias grows, no pixel may be in
    // shadow. Without a bias about half of them are, those whose texel center is nearer to the light; under a
    // perpendicular sun it depends on rounding.
    for (const double angle : {0.0, 20.0, 45.0, 70.0, 86.0})
        for (const int size : {16, 100, 1024}) {
            const Vec3 toLight(std::sin(radians(angle)), std::cos(radians(angle)), 0.03);
            Scene scene = sceneOfObjects({plateObject("floor", 2, 0)},
                                         {directionalLight("sun", toLight), pointLight("lamp", 1.5 * toLight),
                                          pointLight("near", 0.2 * toLight)},
                                         fromAbove(1.9));
            scene.objects[0].rotateDegrees = Vec3(0, 30, 0);
            const std::string settings = kMap + ",shadow_map_size=" + std::to_string(size);
            const Frame frame = draw(scene, settings), bare = draw(scene, settings + ",shadow_map_bias=0");
            for (const Light& light : scene.lights) {
                SCOPED_TRACE(fmt::format("{} {} degrees, {} texels", light.name, angle, size));
                size_t decided = 0, shadowed = 0;
                for (size_t i = 0; i < frame.pixelCount(); ++i) {
                    if (frame.channel("id")[i] == 0) continue;
                    if (sampleLight(light, vectorAt(frame, "P", i)).toLightWorld.y < 0.0501) continue;
                    ++decided;
                    ASSERT_EQ(frame.channel("shadow." + light.name)[i], 0) << i;
                    shadowed += bare.channel("shadow." + light.name)[i] == 1;
                }
                EXPECT_GT(decided, 2000u);
                if (angle < 1 && light.kind == Light::Kind::Directional) continue;
                EXPECT_GT(shadowed, decided / 5);
            }
        }
}

TEST(ShadowMap, BiasOnRelief_PreventsSelfShadowing) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A ramp of two clamped texels is a plane that descends by 0.3 per unit away from the light. With the
    // exact search, only the map has errors.
    SceneObject ramp = squareObject(
        2, std::make_shared<HeightMap>("ramp", 2, 1, std::vector<float>{0, 1}, Wrap::Clamp, Wrap::Clamp),
        0.3);
    const Scene scene = sceneOfObjects({ramp}, {directionalLight("sun", {-1, 0.6, 0})}, fromAbove(0.5));
    const auto shadowed = [&](const std::string& settings) {
        return countShadows(draw(scene, settings), "sun").shadowed;
    };
    EXPECT_EQ(shadowed("exact_cells:shadow=map,shadow_bias=0"), 0u);
    EXPECT_GT(shadowed("exact_cells:shadow=map,shadow_bias=0,shadow_map_bias=0"),
              size_t(kPixels * kPixels / 5));
    // Ten steps end up to a tenth of the depth below the surface, at different points for camera and light.
    // This is the search's error, for which shadow_bias is intended. A point a tenth below the ramp is 3.9
    // tenths away from it along these rays (N.L = 0.25), as far as a point below the polygon (N.L = 0.51)
    // with a margin of two tenths.
    EXPECT_GT(shadowed("linear:shadow=map,shadow_bias=0"), size_t(kPixels * kPixels / 20));
    EXPECT_EQ(shadowed("linear:shadow=map,shadow_bias=0.2"), 0u);
}

// --- lights --------------------------------------------------------------------------------------

/// A box seen from inside.
SceneObject roomObject(double side) {
    SceneObject room = boxObject("room", Vec3(side), Vec3(0));
    for (std::vector<int>* indices : {&room.mesh.faceVertices, &room.mesh.faceUvs, &room.mesh.faceNormals})
        std::reverse(indices->begin(), indices->end()); // all faces have four corners
    for (Vec3& normal : room.mesh.normals)
        normal = -normal;
    return room;
}

TEST(ShadowMap, Lamp_ReachesAllSixFaces) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A lamp at the center of a room 2 wide, with a plate halfway to each wall, 0.2 wide and displaced from
    // the center by (0.1, 0.05) along the next two axes: its shadow on the wall is 0.4 wide and displaced by
    // (0.2, 0.1). Two cameras in opposite corners see three walls each. Nothing else is in shadow, including
    // at the edges and corners of the cube map. Half a texel's diagonal is sqrt(2) / 1024 at the wall.
    std::vector<SceneObject> objects{roomObject(2)};
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Vec3 size(0.2), center(0);
            size[axis] = 0.01;
            center[axis] = sign * 0.505; // its face toward the lamp at 0.5
            center[(axis + 1) % 3] = 0.1;
            center[(axis + 2) % 3] = 0.05;
            objects.push_back(boxObject("plate" + std::to_string(objects.size()), size, center));
        }
    for (const double side : {1.0, -1.0}) {
        Camera camera;
        camera.positionWorld = Vec3(0.9, 0.8, 0.95) * side;
        camera.targetWorld = Vec3(0);
        camera.fovYDegrees = 110;
        camera.width = camera.height = kPixels;
        const Scene scene = sceneOfObjects(objects, {pointLight("lamp", Vec3(0))}, camera);
        const Frame frame = draw(scene, kMap);
        size_t shadowedWalls[3] = {0, 0, 0};
        const size_t decided = expectShadows(frame, "lamp", 1, [&](const Vec3& p) {
            int axis = 0;
            for (int other = 1; other < 3; ++other)
                if (std::abs(p[other]) > std::abs(p[axis])) axis = other;
            const Expected expected =
                inRectangle(p[(axis + 1) % 3], p[(axis + 2) % 3], {0, -0.1}, {0.4, 0.3}, 0.003);
            shadowedWalls[axis] += expected == Expected::Shadow;
            return expected;
        });
        EXPECT_GT(decided, size_t(kPixels * kPixels / 2)) << side;
        for (const size_t pixels : shadowedWalls)
            EXPECT_GT(pixels, 100u) << side;
    }
}

TEST(ShadowMap, NoLights_EqualsFrameWithoutMaps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Scene scene = sceneOfObjects(
        {plateObject("floor", 4, 0), boxObject("pole", {0.1, 1, 0.1}, {0, 0.5, 0})}, {}, fromAbove(3));
    const Frame frame = draw(scene, kMap), without = draw(scene, "linear_binary:shadow=none");
    EXPECT_EQ(frame.channelNames(), without.channelNames());
    for (size_t i = 0; i < frame.pixelCount(); ++i)
        ASSERT_EQ(frame.channel("R")[i], without.channel("R")[i]);
}

TEST(ShadowMap, NoCasters_LeaveAllLit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A lamp beside the floor: five of its six faces are empty. A distant lamp has the whole scene in one
    // texel.
    const Scene scene =
        sceneOfObjects({plateObject("floor", 2, 0)},
                       {pointLight("beside", {3, 0.5, 0}), pointLight("far", {0, 1e4, 0})}, fromAbove(3));
    const Frame frame = draw(scene, kMap);
    for (const char* light : {"beside", "far"}) {
        EXPECT_GT(countShadows(frame, light).pixels, 1000u);
        EXPECT_EQ(countShadows(frame, light).shadowed, 0u) << light;
    }
    // No extent in the map: a square seen edge-on by the sun.
    const Scene edgeOn =
        sceneOfObjects({plateObject("floor", 2, 0)}, {directionalLight("sun", {1, 0, 0})}, fromAbove(3));
    EXPECT_EQ(countShadows(draw(edgeOn, kMap), "sun").shadowed,
              countShadows(draw(edgeOn, kMap), "sun").pixels);
}

TEST(ShadowMap, HitsBeyondRange_AreLit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A relief floor 2 wide, its surface 0.2 below the polygon; both lights shine along -x at 15 to 20
    // degrees, the camera looks at 5 degrees. The visible surface extends 0.2 / tan 5 = 2.29 beyond the
    // polygon's edge, outside the distance range with its margin (half a diagonal, 1.6). Light rays that
    // enter the polygon up to 0.2 / tan 20 = 0.55 before its edge hit these points; beyond that their texels
    // are empty. A box 1 tall, which enlarges the map for the latter, casts the only shadow: x down to -3.4,
    // as wide as the box under the sun, up to 1.4 times as far from z = 0 under the lamp.
    Camera camera = orthographicCamera({5 * std::cos(radians(5.0)), 5 * std::sin(radians(5.0)), 0}, {0, 1, 0},
                                       1.9, kPixels);
    const Vec3 toLight(std::cos(radians(20.0)), std::sin(radians(20.0)), 0);
    const Scene scene = sceneOfObjects(
        {plateObject("floor", 2, 0, constantMap(1), 0.2), boxObject("box", {0.2, 1, 0.4}, {0, 0.5, 0.5})},
        {directionalLight("sun", toLight), pointLight("lamp", 10.0 * toLight)}, camera);
    const Frame frame = draw(scene, kMap);
    const auto beyondRim = [&](const Vec3& p, Expected expected) {
        return p.x < -1 ? expected : Expected::Either;
    };
    const size_t sun = expectShadows(frame, "sun", 1, [&](const Vec3& p) {
        return beyondRim(p, inRectangle(p.x, p.z, {-3.4, 0.3}, {1, 0.7}, 0.01));
    });
    const size_t lamp = expectShadows(frame, "lamp", 1, [&](const Vec3& p) {
        return beyondRim(p, p.z < 0.28 ? Expected::Lit : Expected::Either);
    });
    EXPECT_GT(sun, 3000u);
    EXPECT_GT(lamp, 2000u);
    EXPECT_GT(countShadows(frame, "sun", 1).shadowed, 200u);
}

TEST(ShadowMap, SixteenLights_HaveMapEach) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Sun and lamp in turn around a pole: each light's shadow is the one it has alone.
    Scene scene = sceneOfObjects(
        {plateObject("floor", 4, 0, constantMap(0.5f), 0.1), boxObject("pole", {0.1, 1, 0.1}, {0, 0.4, 0})},
        {}, fromAbove(3));
    std::vector<Light> lights;
    for (int i = 0; i < 16; ++i) {
        const double angle = 2 * kPi * i / 16;
        const Vec3 place(2 * std::cos(angle), 1.5, 2 * std::sin(angle));
        const std::string name = "light" + std::to_string(i);
        lights.push_back(i % 2 ? pointLight(name, place) : directionalLight(name, place));
    }
    scene.lights = lights;
    const std::string settings = kMap + ",shadow_map_size=128";
    const Frame all = draw(scene, settings);
    for (const Light& light : lights) {
        scene.lights = {light};
        const Frame alone = draw(scene, settings);
        size_t different = 0;
        for (size_t i = 0; i < all.pixelCount(); ++i)
            different += all.channel("shadow." + light.name)[i] != alone.channel("shadow." + light.name)[i];
        EXPECT_EQ(different, 0u) << light.name;
        const ShadowCount floor = countShadows(alone, light.name, 1);
        EXPECT_GT(floor.shadowed, 100u) << light.name;
        EXPECT_LT(floor.shadowed, floor.pixels / 10) << light.name;
    }
}

// --- with the rest -------------------------------------------------------------------------------

TEST(ShadowMap, EverySearchAndSurface_Composes) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A plate 0.6 wide at y = 0.6 above a relief 0.1 deep: for any technique, the points around x = -0.6 are
    // in shadow, and those at x > 0.5 are only below the relief, whose slopes are less than the sun's 45
    // degrees. The margin is half of the relief's depth, because parallax mapping gives different results
    // from the light and from the camera.
    const auto waves = std::make_shared<HeightMap>("waves", 4, 1, std::vector<float>{0.4f, 0.5f, 0.6f, 0.5f},
                                                   Wrap::Repeat, Wrap::Repeat);
    const Scene scene =
        sceneOfObjects({plateObject("floor", 4, 0, waves, 0.1), plateObject("plate", 0.6, 0.6)},
                       {directionalLight("sun", {1, 1, 0})}, fromAbove(3));
    RealtimeRenderer renderer(scene, {GlBackend::Auto, -1, 0}, testContext());
    int drawn = 0;
    for (const Manifest& info : listTechniques())
        for (const std::string& surface : surfacesFor(info, listSurfaces())) {
            const std::string name = info.name + "@" + surface + ":shadow=map,shadow_bias=0.5";
            SCOPED_TRACE(name);
            const Frame frame = renderer.render(resolveTechnique(name), nullptr).frame;
            const size_t decided = expectShadows(frame, "sun", 1, [](const Vec3& p) {
                if (p.x > 0.5) return Expected::Lit;
                return std::abs(p.x + 0.65) < 0.15 && std::abs(p.z) < 0.25 ? Expected::Shadow
                                                                           : Expected::Either;
            });
            EXPECT_GT(decided, size_t(kPixels * kPixels / 4));
            ++drawn;
        }
    EXPECT_GE(drawn, 25);
}

TEST(ShadowMap, ShadowLookUps_AreNotCounted) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Scene scene = sceneOfObjects(
        {plateObject("floor", 4, 0, constantMap(0.5f), 0.2), boxObject("box", {0.3, 0.3, 0.3}, {0, 0.2, 0})},
        {directionalLight("sun", {1, 1, 0})}, fromAbove(3));
    const Frame map = draw(scene, kMap), none = draw(scene, "linear_binary:shadow=none");
    for (size_t i = 0; i < map.pixelCount(); ++i)
        ASSERT_EQ(map.channel("cost.fetches")[i], none.channel("cost.fetches")[i]);
}

TEST(ShadowMap, FlatRelief_AgreesWithShadowRays) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Bumps of 1/8 of a square 2 wide, 0.1 deep, the exact search. The two differ along shadow edges, where
    // the map has an error of a texel (0.003) plus the bias, and the ray of 0.02 of the depth: measured 2.9 %
    // of the pixels with 256 texels per side, 0.7 % with 1024.
    const auto bumps = std::make_shared<HeightMap>(
        "bumps", 4, 4,
        std::vector<float>{0, 1, 0.3f, 0.7f, 1, 0.2f, 0, 0.9f, 0.4f, 0.1f, 1, 0, 0.5f, 0.8f, 0.6f, 0.2f},
        Wrap::Repeat, Wrap::Repeat);
    SceneObject floor = plateObject("floor", 2, 0, bumps, 0.1);
    floor.relief->tile = Vec2(4);
    const Scene scene = sceneOfObjects({floor}, {directionalLight("sun", {1, 0.4, 0.3})}, fromAbove(1.6));
    const Frame rays = draw(scene, "exact_cells");
    const auto differing = [&](const std::string& settings) {
        const Frame map = draw(scene, "exact_cells:shadow=map" + settings);
        size_t different = 0;
        for (size_t i = 0; i < map.pixelCount(); ++i)
            different += map.channel("shadow.sun")[i] != rays.channel("shadow.sun")[i];
        return static_cast<double>(different) / static_cast<double>(map.pixelCount());
    };
    const double coarse = differing(",shadow_map_size=256"), fine = differing("");
    EXPECT_LT(coarse, 0.04);
    EXPECT_LT(fine, 0.01);
    const ShadowCount shadowed = countShadows(rays, "sun");
    EXPECT_GT(shadowed.shadowed, shadowed.pixels / 5);
}

TEST(ShadowMap, Sampler_HasOwnUnit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Also if no map is read: the sampler is declared, and a driver that doesn't eliminate it, unlike
    // llvmpipe, finds two types of samplers at unit 0.
    for (const BakedFamily& family : bakedFamilies())
        EXPECT_NE(family.unit, unitBehindBaked()) << family.sampler;
    const CurrentContext current(*testContext());
    const auto expectUnit = [](const GlProgram& program, bool reads, const std::string& name) {
        const GLint location = program.uniform("uShadowMaps");
        if (reads) {
            EXPECT_GE(location, 0) << name;
        }
        if (location < 0) return;
        program.use();
        GLint handle = 0, unit = -1;
        glGetIntegerv(GL_CURRENT_PROGRAM, &handle);
        glGetUniformiv(static_cast<GLuint>(handle), location, &unit);
        EXPECT_EQ(unit, unitBehindBaked()) << name;
    };
    for (const bool reads : {false, true}) {
        expectUnit(*buildPlainProgram(1, reads), reads, "plain");
        for (const char* search : {"linear_binary", "cone_step", "max_mipmap"}) {
            const std::string name = std::string(search) + (reads ? ":shadow=map" : "");
            expectUnit(*buildReliefProgram(resolveTechnique(name), 1), reads, name);
        }
    }
}

TEST(ShadowMap, TooManyLayers_IsMachineError) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A scene has at most 16 lights, that is, 96 layers, so ShadowMaps is tested directly, with one more
    // light than supported layers.
    const CurrentContext current(*testContext());
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    Scene scene;
    scene.lights.assign(static_cast<size_t>(most) + 1, directionalLight("sun", {0, 1, 0}));
    const Technique technique = resolveTechnique(kMap + ",shadow_map_size=16");
    const GpuScene objects(scene, *testContext());
    try {
        ShadowMaps(technique, scene, objects, Vec3(0), *testContext());
        ADD_FAILURE() << most + 1 << " layers were had";
    } catch (const MachineError& error) {
        const std::string expected = "expected at most " + std::to_string(most) + " layers";
        EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
}

TEST(ShadowMap, TooMuchMemory_IsMachineError) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // 16 lamps of six faces of 8192 x 8192 floats: 24 GiB. Only a software rasterizer uses main memory, whose
    // size is known.
    const bool software = testContext()->softwareRasterizer();
    if (!software) GTEST_SKIP() << "the free memory of a GPU can't be queried";
    if (freeMemoryBytes() > uint64_t(24) << 30)
        GTEST_SKIP() << "24 GiB of shadow maps would fit this machine";
    Scene scene = sceneOfObjects({plateObject("floor", 2, 0, constantMap(0.5f), 0.1)}, {}, fromAbove(3));
    for (int i = 0; i < 16; ++i)
        scene.lights.push_back(pointLight("lamp" + std::to_string(i), {0, 1, 0.1 * i}));
    EXPECT_THROW(draw(scene, kMap + ",shadow_map_size=8192"), MachineError);
}

} // namespace
} // namespace plumbline
