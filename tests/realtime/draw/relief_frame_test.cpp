// Frames whose pixels can be derived by hand.
#include "tests/realtime/gl_fixture.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace plumbline {
namespace {

constexpr int kPixels = 64;

std::shared_ptr<const HeightMap> constantMap(float depth) {
    return std::make_shared<HeightMap>(HeightMap::constant("constant", depth));
}

/// width x 1 texels, the same along t.
std::shared_ptr<const HeightMap> profileMap(std::vector<float> depths, Wrap wrap) {
    const auto width = static_cast<int>(depths.size());
    return std::make_shared<HeightMap>("profile", width, 1, std::move(depths), wrap, wrap);
}

/// From above, +x to the right.
Camera fromAbove(double viewHeight, int pixels = kPixels) {
    return orthographicCamera({0, 5, 0}, {0, 0, -1}, viewHeight, pixels);
}

/// A camera in the xy plane at `angle` from the square's normal, +z up: rays go down and toward +x.
Camera fromTheSide(double angleDegrees, double viewHeight, int pixels = kPixels) {
    return orthographicCamera(5.0 *
                                  Vec3(-std::sin(radians(angleDegrees)), std::cos(radians(angleDegrees)), 0),
                              {0, 0, -1}, viewHeight, pixels);
}

/// Calls `check(pixel, ray through its center)` for every covered pixel; returns their number.
size_t forEachHit(const Frame& frame, const Camera& camera,
                  const std::function<void(size_t, const Ray&)>& check) {
    const CameraRays rays(camera);
    size_t count = 0;
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
            const size_t pixel = pixelAt(frame, x, y);
            if (frame.channel("A")[pixel] == 0) continue;
            ++count;
            check(pixel, rays.ray(x + 0.5, y + 0.5));
        }
    return count;
}

TEST(ReliefFrame, ConstantDepth_IsPlaneBelowPolygon) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Depth 0.5 of 0.2: the plane y = -0.1, and the fifth of ten steps falls on it exactly. The square is 2
    // wide, so s = (x + 1) / 2 and t = (1 - z) / 2.
    for (const double angle : {0.0, 30.0, 60.0}) {
        const Camera camera = fromTheSide(angle, 0.8);
        const Frame frame = draw(sceneOf(squareObject(2, constantMap(0.5f), 0.2), camera), "linear_binary");
        const CameraRays rays(camera);
        const size_t hits = forEachHit(frame, camera, [&](size_t pixel, const Ray& ray) {
            const Vec3 expected = ray.at((-0.1 - ray.origin.y) / ray.direction.y);
            const Vec3 found = vectorAt(frame, "P", pixel);
            ASSERT_LT(glm::length(found - expected), 2e-6)
                << found.x << " " << found.y << " " << found.z; // float
            ASSERT_NEAR(frame.channel("Z")[pixel], rays.planarDepth(expected), 2e-6);
            ASSERT_NEAR(stAt(frame, pixel).x, (expected.x + 1) / 2, 2e-6);
            ASSERT_NEAR(stAt(frame, pixel).y, (1 - expected.z) / 2, 2e-6);
            ASSERT_LT(glm::length(vectorAt(frame, "N", pixel) - Vec3(0, 1, 0)), 1e-6);
            ASSERT_EQ(frame.channel("id")[pixel], 1);
            // 5 linear + 6 binary steps for the view ray, and as many for the shadow ray.
            ASSERT_EQ(frame.channel("cost.fetches")[pixel], 22);
            ASSERT_EQ(frame.channel("shadow.sun")[pixel], 0);
        });
        EXPECT_EQ(hits, size_t(kPixels * kPixels)); // the square fills the image
    }
}

TEST(ReliefFrame, DepthOne_IsHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Depth 1 everywhere: only the last linear step reaches it.
    for (const char* technique : {"linear_binary", "linear_binary@quadric", "linear_binary:linear_steps=7"}) {
        const Frame frame =
            draw(sceneOf(squareObject(2, constantMap(1), 0.2), fromTheSide(30, 0.8)), technique);
        EXPECT_EQ(coveredPixels(frame), size_t(kPixels * kPixels)) << technique;
    }
}

TEST(ReliefFrame, Shading_EqualsFormula) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = sceneOf(squareObject(2, constantMap(0.5f), 0.2), fromAbove(0.8));
    scene.objects[0].color = Vec3(0.2, 0.4, 0.8);
    scene.lights = {directionalLight("a", {0, 1, 0}), directionalLight("b", {0, 3, 4}),
                    directionalLight("below", {0, -1, 0})};
    const Frame frame = draw(scene, "linear_binary");
    const double light = kAmbient + 1 + 0.6; // N.L = 1, 3/5; the last light is below: in shadow
    const size_t pixel = pixelAt(frame, 10, 10);
    EXPECT_NEAR(frame.channel("R")[pixel], 0.2 * light, 1e-6);
    EXPECT_NEAR(frame.channel("G")[pixel], 0.4 * light, 1e-6);
    EXPECT_NEAR(frame.channel("B")[pixel], 0.8 * light, 1e-6);
    EXPECT_EQ(frame.channel("shadow.b")[pixel], 0);
    EXPECT_EQ(frame.channel("shadow.below")[pixel], 1);
}

TEST(ReliefFrame, Ramp_IsPlaneWithItsNormal) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Two clamped texels 0 and 1: between their centers D = 2 (s - 1/4). With s = (x + 1) / 2 and depth 0.3
    // the surface is y = -0.3 (x + 1/2) for |x| < 1/2, its normal (0.3, 1, 0) normalized. After 16 bisections
    // of 1/64, the error is 2.4e-7 of the depth.
    const Camera camera = fromTheSide(35, 0.5);
    const Frame frame = draw(sceneOf(squareObject(2, profileMap({0, 1}, Wrap::Clamp), 0.3), camera),
                             "linear_binary:linear_steps=64,binary_steps=16");
    const Vec3 normal = glm::normalize(Vec3(0.3, 1, 0));
    size_t onRamp = 0;
    forEachHit(frame, camera, [&](size_t pixel, const Ray& ray) {
        const double distance =
            -(ray.origin.y + 0.3 * (ray.origin.x + 0.5)) / (ray.direction.y + 0.3 * ray.direction.x);
        const Vec3 expected = ray.at(distance);
        if (std::abs(expected.x) > 0.49) return;
        ++onRamp;
        ASSERT_LT(glm::length(vectorAt(frame, "P", pixel) - expected), 4e-6);
        ASSERT_LT(glm::length(vectorAt(frame, "N", pixel) - normal), 1e-5);
    });
    EXPECT_GT(onRamp, size_t(kPixels * kPixels / 2));
}

TEST(ReliefFrame, DepthAndTile_ScaleNormals) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // E7: n = (D_s sz / sx, 0, 1). The same ramp on a square 4 wide with depth 0.9: slope 2 * 0.9 / 4 = 0.45.
    const Frame frame = draw(sceneOf(squareObject(4, profileMap({0, 1}, Wrap::Clamp), 0.9), fromAbove(0.5)),
                             "normal_mapping");
    const Vec3 normal = glm::normalize(Vec3(0.45, 1, 0));
    EXPECT_LT(glm::length(vectorAt(frame, "N", pixelAt(frame, 32, 32)) - normal), 1e-5);
}

TEST(ReliefFrame, MirroredAndShearedSt_KeepNormalOutward) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // uv = M (x, -z) with any M: the ramp descends along the world direction grad s = M's first row; at depth
    // 0.3 with D = 2 (s - 1/4) the surface is y = -0.6 (s - 1/4), the normal (0.6 ds/dx, 1, 0.6 ds/dz).
    struct Matrix {
        double sx, sz, tx, tz;
    };
    for (const Matrix& m : {Matrix{0.5, 0, 0, -0.5}, Matrix{-0.5, 0, 0, -0.5}, Matrix{0.4, 0.1, 0.3, -0.5}}) {
        SceneObject object = squareObject(2, profileMap({0, 1}, Wrap::Clamp), 0.3);
        object.mesh.uvs.clear();
        for (const Vec3& point : object.mesh.points)
            object.mesh.uvs.emplace_back(0.5 + m.sx * point.x + m.sz * point.z,
                                         0.5 + m.tx * point.x + m.tz * point.z);
        object.mesh.faceUvs = object.mesh.faceVertices;
        const Camera camera = orthographicCamera({-3, 4, 2}, {0, 0, -1}, 0.3, kPixels);
        const Frame frame = draw(sceneOf(object, camera), "linear_binary:linear_steps=64,binary_steps=16");
        const Vec3 normal = glm::normalize(Vec3(0.6 * m.sx, 1, 0.6 * m.sz));
        forEachHit(frame, camera, [&](size_t pixel, const Ray& ray) {
            // (0.6 sx, 1, 0.6 sz) . P = -0.15 is the ramp's plane (s = 1/2 at the origin).
            const Vec3 plane(0.6 * m.sx, 1, 0.6 * m.sz);
            const Vec3 expected =
                ray.at((-0.15 - glm::dot(plane, ray.origin)) / glm::dot(plane, ray.direction));
            ASSERT_LT(glm::length(vectorAt(frame, "P", pixel) - expected), 4e-6);
            ASSERT_LT(glm::length(vectorAt(frame, "N", pixel) - normal), 1e-5);
            ASSERT_NEAR(stAt(frame, pixel).x, 0.5 + m.sx * expected.x + m.sz * expected.z, 4e-6);
            ASSERT_NEAR(stAt(frame, pixel).y, 0.5 + m.tx * expected.x + m.tz * expected.z, 4e-6);
        });
    }
}

TEST(ReliefFrame, TwoRidges_FirstIsHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Two ridges with tops at s = 3/16 and 11/16 of a tile, with equally deep valleys between them. Every ray
    // at 60 degrees crosses 0.2 tan 60 = 0.35 = 0.17 tiles from the polygon to the floor and must stop at the
    // first point with d(t) >= D, found here by marching the exact map with steps of 1e-5 of the ray.
    const auto map = profileMap({1, 0, 1, 1, 1, 0, 1, 1}, Wrap::Repeat);
    const double depth = 0.4;
    const Camera camera = fromTheSide(60, 0.9);
    const Frame frame =
        draw(sceneOf(squareObject(2, map, depth), camera), "linear_binary:linear_steps=256,binary_steps=12");
    size_t compared = 0;
    forEachHit(frame, camera, [&](size_t pixel, const Ray& ray) {
        if (pixel % 37 != 0) return;
        const Vec3 entry = ray.at(-ray.origin.y / ray.direction.y);
        const double travelS = depth * std::tan(radians(60.0)) / 2; // tiles from top to bottom
        int step = 0;
        while (step < 100000 && map->depth(Vec2((entry.x + 1) / 2 + travelS * step * 1e-5, 0)) > step * 1e-5)
            ++step;
        ++compared;
        // One bisected interval (1 / 2^20) and one marching step.
        ASSERT_NEAR(-vectorAt(frame, "P", pixel).y / depth, step * 1e-5, 2e-5) << "entry " << entry.x;
    });
    EXPECT_GT(compared, 100u);
}

TEST(ReliefFrame, Step_CastsShadowOfItsHeight) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A step down from depth 0 to 1 at x = 0, 0.2 high, between two of 512 texels of a square 2 wide; light
    // from -x at 45 degrees. A point on the floor is in shadow if its ray enters left of the edge, that is,
    // up to x = 0.2. The edge is a ramp one texel (0.0039) wide, a search step is 0.2 / 512, and a pixel 0.8
    // / 256 = 0.0031.
    std::vector<float> depths(512, 0);
    std::fill(depths.begin() + 256, depths.end(), 1.0f);
    Scene scene = sceneOf(squareObject(2, profileMap(depths, Wrap::Clamp), 0.2), fromAbove(0.8, 256));
    scene.lights = {directionalLight("left", {-1, 1, 0}), directionalLight("right", {1, 1, 0})};
    const Frame frame = draw(scene, "linear_binary:linear_steps=512");
    const auto left = frame.channel("shadow.left"), right = frame.channel("shadow.right");
    double lastShadow = -1;
    for (int x = 0; x < 256; ++x) {
        const size_t pixel = pixelAt(frame, x, 100);
        const double xWorld = (x + 0.5) / 256 * 0.8 - 0.4;
        if (left[pixel] == 1) lastShadow = xWorld;
        if (xWorld > 0.005 && xWorld < 0.19) {
            EXPECT_EQ(left[pixel], 1) << xWorld;
        }
        if (std::abs(xWorld) > 0.005) {
            EXPECT_EQ(right[pixel], 0) << xWorld; // no occluder there
        }
        if (xWorld < -0.005) {
            EXPECT_EQ(left[pixel], 0) << xWorld;
        }
    }
    EXPECT_NEAR(lastShadow, 0.2, 0.0039 / 2 + 0.2 / 512 + 0.0031);
    // Without cast shadows, only the wall, one texel wide, faces away from the light on the left.
    const Frame without = draw(scene, "linear_binary:linear_steps=64,binary_steps=8,shadow=none");
    size_t shadowed = 0;
    for (int x = 0; x < 256; ++x)
        shadowed += without.channel("shadow.right")[pixelAt(without, x, 100)] == 1 ||
                    without.channel("shadow.left")[pixelAt(without, x, 100)] == 1;
    EXPECT_LE(shadowed, 3u);
}

TEST(ReliefFrame, Bias_PreventsSelfShadowing) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A ramp is a plane, which casts no shadow on itself. Both searches end up to 1/640 of the depth below
    // it. Toward this light the ramp descends by 0.5 of the depth while a ray rises by 1, so for half of the
    // pixels the shadow ray is still inside one step back and, without a bias, shadows them. 0.02 is many
    // times that error.
    Scene scene = sceneOf(squareObject(2, profileMap({0, 1}, Wrap::Clamp), 0.3), fromAbove(0.5));
    scene.lights = {directionalLight("sun", {-1, 0.6, 0})};
    const auto shadowed = [&](const char* technique) {
        size_t count = 0;
        const Frame frame = draw(scene, technique);
        for (const float shadow : frame.channel("shadow.sun"))
            count += shadow == 1;
        return count;
    };
    EXPECT_EQ(shadowed("linear_binary"), 0u);
    EXPECT_GT(shadowed("linear_binary:shadow_bias=0"), size_t(kPixels * kPixels / 20));
}

TEST(ReliefFrame, BackFacingNormal_StaysOnPolygonOrDiscards) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The polygon is front-facing but its shading normal isn't, so the ray rises out of the relief.
    SceneObject object = squareObject(2, profileMap({0, 1, 0.3f}, Wrap::Repeat), 0.3);
    object.mesh.normals = {glm::normalize(Vec3(1, 0.2, 0))};
    object.mesh.faceNormals.assign(object.mesh.faceVertices.size(), 0);
    const Camera camera = fromTheSide(60, 0.5);
    const Frame flat = draw(sceneOf(object, camera), "linear_binary");
    const size_t hits = forEachHit(
        flat, camera, [&](size_t pixel, const Ray&) { ASSERT_NEAR(vectorAt(flat, "P", pixel).y, 0, 1e-6); });
    EXPECT_EQ(hits, size_t(kPixels * kPixels));
    EXPECT_EQ(coveredPixels(draw(sceneOf(object, camera), "linear_binary@quadric")), 0u);
}

TEST(ReliefFrame, PointLight_LightsFromItsPosition) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = sceneOf(squareObject(2, constantMap(0), 0.2), fromAbove(1.6));
    Light lamp;
    lamp.name = "lamp";
    lamp.kind = Light::Kind::Point;
    lamp.positionWorld = Vec3(0.5, 0.5, -0.25);
    scene.lights = {lamp};
    const Camera camera = scene.camera;
    const Frame frame = draw(scene, "linear_binary");
    forEachHit(frame, camera, [&](size_t pixel, const Ray&) {
        const Vec3 point = vectorAt(frame, "P", pixel);
        const Vec3 toLight = glm::normalize(lamp.positionWorld - point);
        ASSERT_NEAR(frame.channel("R")[pixel], 0.8 * (kAmbient + toLight.y), 2e-6);
    });
}

TEST(ReliefFrame, ZeroDepth_IsPolygon) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto bumpy = profileMap({0.1f, 0.9f, 0.4f}, Wrap::Repeat);
    for (const double depth : {0.0, 1e-30}) {
        const Frame frame = draw(sceneOf(squareObject(2, bumpy, depth), fromAbove(0.8)), "linear_binary");
        const size_t pixel = pixelAt(frame, 20, 20);
        EXPECT_EQ(frame.channel("Z")[pixel], 5);
        EXPECT_EQ(vectorAt(frame, "N", pixel), Vec3(0, 1, 0));
        EXPECT_EQ(coveredPixels(frame), size_t(kPixels * kPixels));
    }
}

TEST(ReliefFrame, MissesAndHits_HoldDefinedValues) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto map = profileMap({0, 1, 0.3f, 0.7f, 1}, Wrap::Repeat);
    // Perpendicular, grazing, from behind, in the plane; a torus has all angles at once, a sphere many
    // tangent frames.
    std::vector<Scene> scenes;
    for (const double angle : {0.0, 89.0, 89.99, 90.0, 100.0})
        scenes.push_back(sceneOf(squareObject(2, map, 0.3), fromTheSide(angle, 3)));
    for (ControlMesh mesh : {makeTorus(1, 0.4, 12, 8), makeSphere(1, 2), makeTeapot(2)}) {
        SceneObject object;
        object.name = mesh.name;
        object.mesh = std::move(mesh);
        object.relief = Relief{map, 0.1, 0.02, Vec2(6, 4), Vec2(0)};
        Scene scene = sceneOf(object, Camera());
        scene.camera.positionWorld = Vec3(0.5, 1.5, 4);
        scene.camera.width = scene.camera.height = 200;
        scenes.push_back(scene);
    }
    for (const Scene& scene : scenes)
        for (const char* technique : {"linear_binary", "linear_binary@quadric", "normal_mapping",
                                      "linear_binary@quadric:filter=hardware"}) {
            SCOPED_TRACE(scene.objects[0].name + " " + technique);
            const Frame frame = draw(scene, technique);
            const auto coverage = frame.channel("A");
            const float background[] = {0.25f, 0.5f, 0.75f};
            for (const std::string& name : frame.channelNames()) {
                const auto plane = frame.channel(name);
                for (size_t i = 0; i < plane.size(); ++i) {
                    if (coverage[i] == 1) {
                        ASSERT_TRUE(std::isfinite(plane[i])) << name << " at " << i;
                        continue;
                    }
                    ASSERT_EQ(coverage[i], 0);
                    const float miss = name.size() == 1 && std::string("RGB").find(name) != std::string::npos
                                           ? background[std::string("RGB").find(name)]
                                           : channelInfo(name).missValue;
                    ASSERT_TRUE(plane[i] == miss || (std::isnan(plane[i]) && std::isnan(miss))) << name;
                }
            }
        }
}

TEST(ReliefFrame, LargeSt_KeepsDigits) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The same relief at st larger by 1000 tiles: equal except for st. The resolution of a float there is
    // 1/8192 of a tile, which would lose 1/64 of the map's smallest feature if the shader used it.
    const auto map = profileMap({0, 1, 0.3f, 0.7f, 1}, Wrap::Repeat);
    Scene near = sceneOf(squareObject(2, map, 0.3), fromTheSide(40, 0.8)), far = near;
    far.objects[0].relief->uvOffset = Vec2(1000, -500);
    const Frame a = draw(near, "linear_binary"), b = draw(far, "linear_binary");
    for (size_t i = 0; i < a.pixelCount(); ++i) {
        ASSERT_NEAR(a.channel("Z")[i], b.channel("Z")[i], 1e-5);
        ASSERT_NEAR(a.channel("st.S")[i] + 1000, b.channel("st.S")[i], 1e-4);
        ASSERT_NEAR(a.channel("st.T")[i] - 500, b.channel("st.T")[i], 1e-4);
    }
}

TEST(ReliefFrame, FarTinyAndHugeScenes_RenderEqual) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto map = profileMap({0, 1, 0.3f, 0.7f, 1}, Wrap::Repeat);
    const auto sceneAt = [&](double scale, const Vec3& shift) {
        SceneObject object;
        object.name = "torus";
        object.mesh = makeTorus(1, 0.4, 12, 8);
        object.relief = Relief{map, 0.1 * scale, 0, Vec2(6, 4), Vec2(0)};
        object.scale = scale;
        object.translate = shift;
        Scene scene = sceneOf(object, Camera());
        scene.camera.positionWorld = Vec3(0.5, 1.5, 4) * scale + shift;
        scene.camera.targetWorld = shift;
        scene.camera.width = scene.camera.height = 128;
        return scene;
    };
    for (const char* technique : {"linear_binary", "linear_binary@quadric"}) {
        const Frame expected = draw(sceneAt(1, Vec3(0)), technique);
        for (const auto& [scale, shift] :
             {std::pair(1e-3, Vec3(0)), std::pair(1e3, Vec3(0)), std::pair(1.0, Vec3(1e5, -2e5, 3e5)),
              std::pair(1e4, Vec3(1e6, 0, 0))}) {
            const Frame found = draw(sceneAt(scale, shift), technique);
            size_t different = 0;
            for (size_t i = 0; i < expected.pixelCount(); ++i) {
                const float a = expected.channel("Z")[i], b = found.channel("Z")[i];
                const bool same = (std::isinf(a) && std::isinf(b)) || std::abs(a - b / scale) < 1e-4;
                different += !same;
            }
            // A few pixels depend on rounding: at a silhouette, or where a ridge is found in one search step
            // more or less.
            EXPECT_LE(different, expected.pixelCount() / 500)
                << technique << " scale " << scale << " at " << shift.x;
        }
    }
}

TEST(ReliefFrame, TriangleBounds_DiscardHitsOutside) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A floor of constant depth 1 below a square, seen at 45 degrees: the hit is 0.3 world units, of the
    // square's width of 2, farther along s than the fragment. The remaining pixels are those whose hit is
    // inside the fragment's triangle.
    const Scene scene =
        sceneOf(squareObject(2, std::make_shared<HeightMap>(HeightMap::constant("floor", 1)), 0.3),
                fromTheSide(45, 3));
    const Frame whole = draw(scene, "linear_binary"),
                bounded = draw(scene, "linear_binary:triangle_bounds=true");
    size_t kept = 0, dropped = 0;
    for (size_t i = 0; i < whole.pixelCount(); ++i) {
        if (whole.channel("A")[i] == 0) continue;
        const Vec2 st = stAt(whole, i);
        const bool inSquare = st.x >= 0 && st.x <= 1 && st.y >= 0 && st.y <= 1;
        if (bounded.channel("A")[i] == 1) {
            ++kept;
            ASSERT_TRUE(inSquare) << st.x << " " << st.y;
        } else {
            ++dropped;
        }
    }
    // Each triangle, with legs of 1 in st, loses the area that a shift by 0.15 moves out of it: 0.15 -
    // 0.15^2/2 of 1/2. Hits in the neighboring triangle are discarded too, so in total 2 (0.15 - 0.01125) =
    // 0.2775.
    const double share = static_cast<double>(dropped) / static_cast<double>(kept + dropped);
    EXPECT_NEAR(share, 0.2775, 0.02); // pixels along edges: 64 per side
    const Frame off = draw(scene, "linear_binary:triangle_bounds=false");
    EXPECT_EQ(coveredPixels(off), coveredPixels(whole));
}

TEST(ReliefFrame, DepthCorrection_OrdersReliefs) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The relief's floor is at y = -0.2, a plain square at -0.1, which is visible where the relief is
    // deepest.
    SceneObject plain = squareObject(2, nullptr, 0);
    plain.translate = Vec3(0, -0.1, 0);
    plain.name = "plain";
    std::vector<float> depths(512, 0);
    std::fill(depths.begin() + 256, depths.end(), 1.0f);
    for (const bool plainFirst : {false, true}) {
        Scene scene = sceneOf(squareObject(2, profileMap(depths, Wrap::Clamp), 0.2), fromAbove(0.8));
        scene.objects.insert(plainFirst ? scene.objects.begin() : scene.objects.end(), plain);
        const Frame frame = draw(scene, "linear_binary");
        const float reliefId = plainFirst ? 2 : 1;
        EXPECT_EQ(frame.channel("id")[pixelAt(frame, 5, 30)], reliefId);
        EXPECT_EQ(frame.channel("id")[pixelAt(frame, 60, 30)], 3 - reliefId);
        EXPECT_NEAR(frame.channel("Z")[pixelAt(frame, 60, 30)], 5.1, 1e-5);
        EXPECT_EQ(frame.channel("cost.fetches")[pixelAt(frame, 60, 30)], 0);
    }
}

TEST(ReliefFrame, NoDepthCorrection_OrdersPolygons) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Seen from above: "high", its polygon at y = 0, its relief everywhere 0.2 below; "low", its polygon at y
    // = -0.05, its relief 0.2 below on the left and on top on the right. According to the hits, "high" is at
    // -0.2 and "low" at -0.25 and -0.05, so "low" is visible on the right; according to the polygons, "high"
    // occludes it everywhere. After six bisections of a tenth, the error is 0.2 / 640.
    std::vector<float> depths(512, 1);
    std::fill(depths.begin() + 256, depths.end(), 0.0f);
    Scene scene = sceneOf(squareObject(2, constantMap(1), 0.2), fromAbove(0.8));
    SceneObject low = squareObject(2, profileMap(depths, Wrap::Clamp), 0.2);
    low.name = "low";
    low.translate = Vec3(0, -0.05, 0);
    scene.objects.push_back(low);
    const Frame corrected = draw(scene, "linear_binary"),
                polygons = draw(scene, "linear_binary:depth_correction=false");
    for (const int x : {5, 60}) {
        const size_t pixel = pixelAt(corrected, x, 30);
        const bool right = x > 32;
        EXPECT_EQ(corrected.channel("id")[pixel], right ? 2 : 1);
        EXPECT_NEAR(corrected.channel("Z")[pixel], right ? 5.05 : 5.2, 0.2 / 640 + 1e-5);
        EXPECT_EQ(polygons.channel("id")[pixel], 1);
        EXPECT_NEAR(polygons.channel("Z")[pixel], 5, 1e-5);
        EXPECT_NEAR(vectorAt(polygons, "P", pixel).y, -0.2, 1e-5); // the hit's, as are normal, st and light
    }
}

} // namespace
} // namespace plumbline
