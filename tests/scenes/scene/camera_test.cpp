#include "scenes/scene/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace plumbline {
namespace {

/// 4 x 2 pixels with a vertical field of view of 90 degrees, at (0,0,3) looking at the origin. At planar
/// depth 1 the image is 2 tan 45 = 2 high, so a pixel is 1 x 1 and the image extends from x = -2 to 2.
Camera squareRootFreeCamera() {
    Camera camera;
    camera.fovYDegrees = 90;
    camera.width = 4;
    camera.height = 2;
    return camera;
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

TEST(Camera, TopLeftPixel_HasExactRay) {
    const CameraRays rays(squareRootFreeCamera());
    const Ray ray = rays.ray(0.5, 0.5);
    expectNear(ray.origin, {0, 0, 3}, 0);
    // Center of the top-left pixel: 1.5 left of and 0.5 above the middle, at depth 1 along -Z.
    expectNear(ray.direction, glm::normalize(Vec3(-1.5, 0.5, -1)), 1e-15);
}

TEST(Camera, WorldPoint_HasExactPixel) {
    // (1, -0.5, 1) lies 2 in front of the camera at (0,0,3); at depth 1 that is (0.5, -0.25): half a pixel
    // right of the middle (2, 1), a quarter below.
    expectNear(pixelFromWorld(squareRootFreeCamera(), {1, -0.5, 1}), {2.5, 1.25, 2}, 1e-15);
}

TEST(Camera, Orthographic_HasExactPixel) {
    Camera camera = squareRootFreeCamera();
    camera.projection = Camera::Projection::Orthographic;
    camera.viewHeight = 4; // a pixel is 2 x 2 world units
    expectNear(pixelFromWorld(camera, {2, 1, -7}), {3, 0.5, 10}, 1e-15);
    const Ray ray = CameraRays(camera).ray(3, 0.5);
    expectNear(ray.origin, {2, 1, 3}, 1e-15);
    expectNear(ray.direction, {0, 0, -1}, 1e-15);
}

TEST(Camera, Up_TurnsImage) {
    Camera camera = squareRootFreeCamera();
    camera.upWorld = {2, 0, 0}; // +X is up, so +Y points to the left: right = forward x up = -Y
    const Vec3 pixel = pixelFromWorld(camera, {0, 1, 2});
    expectNear(pixel, {2 - 1, 1, 1}, 1e-15);
}

TEST(Camera, NearAndFar_AreMinusOneAndOneInClipSpace) {
    for (const auto projection : {Camera::Projection::Perspective, Camera::Projection::Orthographic}) {
        Camera camera = squareRootFreeCamera();
        camera.projection = projection;
        const Mat4 clipFromWorld = clipFromView(camera, 0.5, 8) * viewFromWorld(camera);
        for (const auto& [depth, ndc] : {std::pair{0.5, -1.0}, std::pair{8.0, 1.0}}) {
            const Vec4 clip = clipFromWorld * Vec4(0, 0, 3 - depth, 1);
            EXPECT_NEAR(clip.z / clip.w, ndc, 1e-14);
        }
    }
}

TEST(Camera, TowardCamera_IsUnitAndOpposite) {
    Camera camera = squareRootFreeCamera();
    expectNear(CameraRays(camera).towardCamera({4, 0, 0}), {-0.8, 0, 0.6}, 1e-15); // 3-4-5 triangle
    camera.projection = Camera::Projection::Orthographic;
    expectNear(CameraRays(camera).towardCamera({4, 0, 0}), {0, 0, 1}, 1e-15);
}

Camera arbitraryCamera() {
    const auto real = [](int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; };
    Camera camera;
    camera.positionWorld = {real(-9, 9), real(-9, 9), real(-9, 9)};
    camera.targetWorld = {real(-9, 9), real(-9, 9), real(-9, 9)};
    camera.upWorld = {real(-1, 1), real(-1, 1), real(-1, 1)};
    camera.fovYDegrees = real(5, 170);
    camera.viewHeight = real(1, 20);
    camera.width = *rc::gen::inRange(1, 2000);
    camera.height = *rc::gen::inRange(1, 2000);
    if (*rc::gen::arbitrary<bool>()) camera.projection = Camera::Projection::Orthographic;
    const Vec3 view = camera.targetWorld - camera.positionWorld;
    RC_PRE(glm::length(view) > 0.1);
    RC_PRE(glm::length(glm::cross(view, camera.upWorld)) > 0.05);
    return camera;
}

/// A few thousand roundings of doubles at coordinates up to about 2000 pixels.
constexpr double kPixelTolerance = 1e-7;

RC_GTEST_PROP(CameraProperty, PointOnPixelRay_ProjectsToPixel, ()) {
    const Camera camera = arbitraryCamera();
    const double x = *rc::gen::inRange(0, camera.width * 16) / 16.0;
    const double y = *rc::gen::inRange(0, camera.height * 16) / 16.0;
    const double distance = *rc::gen::inRange(1, 100000) / 1000.0;
    const CameraRays rays(camera);
    const Vec3 point = rays.ray(x, y).at(distance);
    const Vec3 pixel = pixelFromWorld(camera, point);
    // At the borders of wide views, the planar depth is a small fraction of the distance.
    const double tolerance = kPixelTolerance * std::max(1.0, distance / pixel.z);
    RC_ASSERT(std::abs(pixel.x - x) < tolerance);
    RC_ASSERT(std::abs(pixel.y - y) < tolerance);
    RC_ASSERT(std::abs(pixel.z - rays.planarDepth(point)) < 1e-10);
}

RC_GTEST_PROP(CameraProperty, ClipSpace_AgreesWithPixels, ()) {
    const Camera camera = arbitraryCamera();
    const double x = *rc::gen::inRange(0, camera.width * 16) / 16.0;
    const double y = *rc::gen::inRange(0, camera.height * 16) / 16.0;
    const Vec3 point = CameraRays(camera).ray(x, y).at(5.0);
    const Vec4 clip = clipFromView(camera, 0.01, 100) * viewFromWorld(camera) * Vec4(point, 1);
    // The left edge of the picture is x_ndc = -1 and its top y_ndc = +1.
    RC_ASSERT(std::abs(clip.x / clip.w - (2 * x / camera.width - 1)) < 1e-9);
    RC_ASSERT(std::abs(clip.y / clip.w - (1 - 2 * y / camera.height)) < 1e-9);
}

RC_GTEST_PROP(CameraProperty, View_IsRotation, ()) {
    const Camera camera = arbitraryCamera();
    const Mat3 rotation(viewFromWorld(camera));
    RC_ASSERT(std::abs(glm::determinant(rotation) - 1) < 1e-12);
    const Vec4 target = viewFromWorld(camera) * Vec4(camera.targetWorld, 1);
    RC_ASSERT(std::abs(target.x) < 1e-12 * 100);
    RC_ASSERT(std::abs(target.y) < 1e-12 * 100);
    RC_ASSERT(target.z < 0);
}

} // namespace
} // namespace plumbline
