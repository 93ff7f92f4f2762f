// Surfaces seen from behind.
#include "realtime/draw/back_sides.h"
#include "scenes/mesh/mesh_edges.h"
#include "tests/realtime/draw/shadow_scenes.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace plumbline {
namespace {

Camera fromBelow(double angleDegrees) {
    return orthographicCamera(5.0 *
                                  Vec3(-std::sin(radians(angleDegrees)), -std::cos(radians(angleDegrees)), 0),
                              {0, 0, 1}, 0.8, 48);
}

/// Smooth enough that ten steps find every first crossing.
std::shared_ptr<const HeightMap> gentleMap() {
    return std::make_shared<HeightMap>("gentle", 4, 4,
                                       std::vector<float>{0.3f, 0.4f, 0.5f, 0.4f, 0.4f, 0.6f, 0.7f, 0.5f,
                                                          0.5f, 0.7f, 0.6f, 0.5f, 0.4f, 0.5f, 0.4f, 0.3f});
}

/// Expects every pixel of a frame to show the back of y = -depth d(st) over the square of side 2, st = ((x +
/// 1) / 2, (1 - z) / 2), on its own ray.
void expectBackOfRelief(const Frame& frame, const Scene& scene, double tolerance, const std::string& what) {
    const Relief& relief = *scene.objects[0].relief;
    const CameraRays rays(scene.camera);
    ASSERT_EQ(coveredPixels(frame), frame.pixelCount()) << what;
    double worst = 0;
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel) {
        const Vec3 at = vectorAt(frame, "P", pixel);
        const Vec2 st(0.5 * (at.x + 1), 0.5 * (1 - at.z));
        worst = std::max(worst, std::abs(at.y + relief.depth * relief.map->depth(st)));
        const Ray ray = rays.ray(pixelCenter(pixel, static_cast<size_t>(frame.width())));
        const Vec3 off = at - ray.origin;
        EXPECT_LT(glm::length(off - glm::dot(off, ray.direction) * ray.direction), 1e-5) << what;
        EXPECT_LT(glm::length(stAt(frame, pixel) - st), 1e-5) << what;
        EXPECT_EQ(frame.channel("facing")[pixel], -1) << what;
        EXPECT_EQ(frame.channel("fault")[pixel], 0) << what;
        const Vec2 gradient = relief.map->sample(st).gradient; // outward is +y, also from behind
        const Vec3 normal =
            glm::normalize(Vec3(0.5 * relief.depth * gradient.x, 1, -0.5 * relief.depth * gradient.y));
        EXPECT_LT(glm::length(vectorAt(frame, "N", pixel) - normal), 0.02) << what;
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_LT(worst, tolerance) << what;
}

TEST(BackSides, ReliefFromBehind_IsItsOwnSurface) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // By the search: within the error of its steps, of voxels as wide as half the square, or of rounding.
    const std::array<std::pair<const char*, double>, 9> techniques{{{"exact_cells", 1e-6},
                                                                    {"exact_cells@quadric", 1e-6},
                                                                    {"max_mipmap", 1e-6},
                                                                    {"linear_binary", 5e-4},
                                                                    {"linear_binary@quadric_nearest", 5e-4},
                                                                    {"cone_step_relaxed", 5e-4},
                                                                    {"cone_step_quad", 5e-3},
                                                                    {"sphere_tracing", 1e-2},
                                                                    {"linear_secant1", 2e-3}}};
    for (const double angle : {0.0, 40.0}) {
        const Scene scene = sceneOf(squareObject(2, gentleMap(), 0.1), fromBelow(angle));
        for (const auto& [technique, tolerance] : techniques)
            expectBackOfRelief(draw(scene, technique), scene, tolerance, technique);
    }
}

// Without displacement, what is seen is the polygon.
TEST(BackSides, NormalMapping_StaysOnPolygon) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Frame frame = draw(sceneOf(squareObject(2, gentleMap(), 0.1), fromBelow(30)), "normal_mapping");
    ASSERT_EQ(coveredPixels(frame), frame.pixelCount());
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel)
        ASSERT_NEAR(vectorAt(frame, "P", pixel).y, 0, 1e-6);
}

// The inner wall of a cylinder, its relief of constant depth 0.5 * 0.2 is the cylinder of radius 0.9.
TEST(BackSides, InnerWallOnQuadric_HasReliefsRadius) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    SceneObject tube;
    tube.name = "tube";
    tube.mesh = makeCylinder(1, 2, 16, 2);
    tube.proxyRate = 4;
    tube.relief =
        Relief{std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f)), 0.2, 0, Vec2(1), Vec2(0)};
    Camera camera;
    camera.positionWorld = Vec3(0, 0, 0.4);
    camera.targetWorld = Vec3(0, 0, -1);
    camera.width = camera.height = 48;
    const Frame frame = draw(sceneOf(tube, camera), "exact_cells@quadric_full");
    ASSERT_EQ(coveredPixels(frame), frame.pixelCount());
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel) {
        const Vec3 at = vectorAt(frame, "P", pixel);
        EXPECT_NEAR(std::hypot(at.x, at.z), 0.9, 0.01);
        EXPECT_EQ(frame.channel("facing")[pixel], -1);
    }
}

// The light is below as the camera is: the side that is seen faces it. A light above leaves it in shadow.
TEST(BackSides, Light_IsThatOfTheSeenSide) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const bool relief : {true, false})
        for (const char* technique : {"exact_cells", "exact_cells:shadow=map"}) {
            Scene scene = sceneOf(squareObject(2, relief ? gentleMap() : nullptr, 0.1), fromBelow(20));
            scene.lights = {directionalLight("below", {0.2, -1, 0.1}),
                            directionalLight("above", {0.2, 1, 0.1})};
            const Frame frame = draw(scene, technique);
            EXPECT_EQ(countShadows(frame, "below").shadowed, 0u) << technique << relief;
            EXPECT_EQ(countShadows(frame, "above").shadowed, frame.pixelCount()) << technique << relief;
        }
}

// Half of the square is a step down of 0.1. A light from below, at 45 degrees toward the step, shadows 0.1 of
// the higher half, which is farther from it.
TEST(BackSides, ReliefFromBehind_ShadowsItself) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto step = std::make_shared<HeightMap>(
        "step", 64, 1,
        [] {
            std::vector<float> depths(64, 1.0f);
            std::fill(depths.begin() + 32, depths.end(), 0.0f); // x > 0 is high: depth 0
            return depths;
        }(),
        Wrap::Clamp, Wrap::Clamp);
    Scene scene = sceneOf(squareObject(2, step, 0.1), orthographicCamera({0, -5, 0}, {0, 0, 1}, 0.8, 64));
    scene.lights = {directionalLight("sun", {-1, -1, 0})};
    for (const char* technique : {"exact_cells", "exact_cells:shadow=map"}) {
        const Frame frame = draw(scene, technique);
        const size_t decided = expectShadows(frame, "sun", 1, [](const Vec3& at) {
            const double margin = 0.04; // a texel, over which the step falls
            if (std::abs(at.x) < margin || std::abs(at.x - 0.1) < margin) return Expected::Either;
            return at.x > 0 && at.x < 0.1 ? Expected::Shadow : Expected::Lit;
        });
        EXPECT_GT(decided, frame.pixelCount() / 2) << technique;
    }
}

TEST(BackSides, CulledSheet_ShowsNothing) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const bool relief : {true, false}) {
        Scene scene = sceneOf(squareObject(2, relief ? gentleMap() : nullptr, 0.1), fromBelow(20));
        scene.objects[0].cull = Cull::Back;
        EXPECT_EQ(coveredPixels(draw(scene, "exact_cells")), 0u);
        scene.objects[0].cull = Cull::None;
        EXPECT_GT(coveredPixels(draw(scene, "exact_cells")), 0u);
    }
}

Scene torusScene(Cull cull) {
    SceneObject torus;
    torus.name = "torus";
    torus.mesh = makeTorus(1, 0.4, 12, 8);
    torus.relief = Relief{gentleMap(), 0.1, 0, Vec2(6, 4), Vec2(0)};
    torus.cull = cull;
    Camera camera;
    camera.positionWorld = Vec3(0.5, 1.5, 4);
    camera.width = 96;
    camera.height = 64;
    return sceneOf(torus, camera);
}

// The flat surface finds hits of grazing rays too far away, some beyond the column's far wall.
TEST(BackSides, FarWallOfColumn_StaysBehindItsFront) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    SceneObject column;
    column.name = "column";
    column.mesh = makeCylinder(1, 4, 16, 2);
    column.relief = Relief{gentleMap(), 0.1, 0, Vec2(6, 2), Vec2(0)};
    Camera camera;
    camera.positionWorld = Vec3(0, 0, 5); // its ends aren't in the picture
    camera.width = 96;
    camera.height = 64;
    column.cull = Cull::Back;
    const Frame culled = draw(sceneOf(column, camera), "linear_binary");
    column.cull = Cull::Auto;
    const Frame both = draw(sceneOf(column, camera), "linear_binary");
    ASSERT_GT(coveredPixels(culled), 500u);
    EXPECT_TRUE(std::ranges::equal(both.channel("Z"), culled.channel("Z")));
}

TEST(BackSides, ClosedMesh_IsCulledUnlessAskedFor) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto backs = [](const Scene& scene) {
        const Frame frame = draw(scene, "linear_binary@quadric");
        const auto facing = frame.channel("facing");
        return std::count(facing.begin(), facing.end(), -1.0f);
    };
    EXPECT_EQ(backs(torusScene(Cull::Auto)), 0);
    EXPECT_EQ(backs(torusScene(Cull::None)), 0); // from outside a front is nearer everywhere
    Scene inside = torusScene(Cull::Auto);
    inside.camera.positionWorld = {1, 0, 0};
    inside.camera.targetWorld = {1, 0, -1};
    EXPECT_GT(backs(inside), 0);
}

ProxyMesh proxyOf(ControlMesh mesh, bool inward) {
    SceneObject object;
    object.mesh = std::move(mesh);
    if (inward) { // each face the other way around
        size_t first = 0;
        for (const int size : object.mesh.faceSizes) {
            const auto begin = object.mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(first);
            std::reverse(begin, begin + size);
            const auto uvs = object.mesh.faceUvs.begin() + static_cast<std::ptrdiff_t>(first);
            std::reverse(uvs, uvs + size);
            first += static_cast<size_t>(size);
        }
    }
    return buildProxyMesh(object);
}

TEST(BackSides, ViewerOfClosedMesh_SeesBackFirstFromItsSolid) {
    const Viewer inTube{false, {1, 0, 0}}, inHole{false, {0, 0, 0}}, outside{false, {0, 3, 0}},
        distant{true, {0, 1, 0}};
    const ProxyMesh outward = proxyOf(makeTorus(1, 0.4, 12, 8), false),
                    inward = proxyOf(makeTorus(1, 0.4, 12, 8), true);
    EXPECT_TRUE(seesBackFirst(outward, inTube));
    EXPECT_FALSE(seesBackFirst(inward, inTube)); // a room
    for (const Viewer& viewer : {inHole, outside, distant}) {
        EXPECT_FALSE(seesBackFirst(outward, viewer));
        EXPECT_TRUE(seesBackFirst(inward, viewer));
    }
}

// An orthographic camera whose plane cuts an object sees it cut open.
TEST(BackSides, OrthographicCameraWithin_SeesBackFirst) {
    const ProxyMesh torus = proxyOf(makeTorus(1, 0.4, 12, 8), false);
    Camera camera = orthographicCamera({0, 0.1, 0}, {0, 0, 1}, 3, 8);
    EXPECT_TRUE(seesBackFirst(torus, Viewer::ofCamera(camera)));
    camera.positionWorld = {0, 2, 0};
    EXPECT_FALSE(seesBackFirst(torus, Viewer::ofCamera(camera)));
}

TEST(BackSides, ClosedMeshes_AreRecognized) {
    EXPECT_TRUE(isClosed(makeTorus(1, 0.4, 12, 8)));
    EXPECT_TRUE(isClosed(makeBox({1, 1, 1}, 2)));
    EXPECT_FALSE(isClosed(makePlane(1, 1, 1, 1)));
    EXPECT_FALSE(isClosed(makeCylinder(1, 2, 16, 2)));
    ControlMesh holed = makeBox({1, 1, 1}, 1);
    holed.tags.holes.push_back({0});
    EXPECT_FALSE(isClosed(holed));
    ControlMesh turned = makeBox({1, 1, 1}, 1); // one face the other way around: no inside
    std::reverse(turned.faceVertices.begin(), turned.faceVertices.begin() + turned.faceSizes[0]);
    EXPECT_FALSE(isClosed(turned));
}

} // namespace
} // namespace plumbline
