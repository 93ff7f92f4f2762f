#include "scenes/scene/camera.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cassert>
#include <cmath>

namespace plumbline {
namespace {

/// Orthonormal right-handed view axes in world space.
struct ViewAxes {
    Vec3 right, up, forward;
};

ViewAxes viewAxes(const Camera& camera) {
    const Mat4 view = viewFromWorld(camera);
    return {Vec3(glm::row(view, 0)), Vec3(glm::row(view, 1)), -Vec3(glm::row(view, 2))};
}

/// Pixel size in world units, for a perspective camera at planar depth 1. Pixels are square.
double pixelSide(const Camera& camera) {
    const double pictureHeight = camera.projection == Camera::Projection::Perspective
                                     ? 2.0 * std::tan(0.5 * radians(camera.fovYDegrees))
                                     : camera.viewHeight;
    return pictureHeight / camera.height;
}

} // namespace

Mat4 viewFromWorld(const Camera& camera) {
    return glm::lookAtRH(camera.positionWorld, camera.targetWorld, glm::normalize(camera.upWorld));
}

Mat4 clipFromView(const Camera& camera, double near, double far) {
    assert(0 < near && near < far);
    const double halfHeight = 0.5 * pixelSide(camera) * camera.height;
    const double halfWidth = 0.5 * pixelSide(camera) * camera.width;
    if (camera.projection == Camera::Projection::Orthographic)
        return glm::orthoRH_NO(-halfWidth, halfWidth, -halfHeight, halfHeight, near, far);
    // glm::perspectiveRH_NO isn't used: it computes the width from the aspect ratio, so its last bits would
    // differ from those of the camera's rays.
    Mat4 matrix(0.0);
    matrix[0][0] = 1.0 / halfWidth;
    matrix[1][1] = 1.0 / halfHeight;
    // z_ndc = (A z_view + B) / -z_view with -1 at z_view = -near and +1 at -far.
    matrix[2][2] = -(far + near) / (far - near);
    matrix[3][2] = -2.0 * far * near / (far - near);
    matrix[2][3] = -1.0;
    return matrix;
}

Vec3 pixelFromWorld(const Camera& camera, const Vec3& positionWorld) {
    const ViewAxes axes = viewAxes(camera);
    const Vec3 offset = positionWorld - camera.positionWorld;
    const double planarDepth = glm::dot(offset, axes.forward);
    const bool perspective = camera.projection == Camera::Projection::Perspective;
    const double pixel = pixelSide(camera) * (perspective ? planarDepth : 1.0);
    return {0.5 * camera.width + glm::dot(offset, axes.right) / pixel,
            0.5 * camera.height - glm::dot(offset, axes.up) / pixel, planarDepth};
}

CameraRays::CameraRays(const Camera& camera)
    : origin_(camera.positionWorld), centerX_(0.5 * camera.width), centerY_(0.5 * camera.height),
      perspective_(camera.projection == Camera::Projection::Perspective) {
    const ViewAxes axes = viewAxes(camera);
    const double side = pixelSide(camera);
    right_ = axes.right * side;
    up_ = axes.up * side;
    forward_ = axes.forward;
}

Ray CameraRays::ray(double x, double y) const {
    const Vec3 offset = right_ * (x - centerX_) + up_ * (centerY_ - y);
    if (perspective_) return {origin_, glm::normalize(forward_ + offset)};
    return {origin_ + offset, forward_};
}

Vec3 CameraRays::towardCamera(const Vec3& positionWorld) const {
    if (!perspective_) return -forward_;
    const Vec3 offset = origin_ - positionWorld;
    const double distance = glm::length(offset);
    return distance > 0 ? offset / distance : -forward_;
}

} // namespace plumbline
