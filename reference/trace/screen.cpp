#include "reference/trace/screen.h"

#include <glm/gtc/matrix_access.hpp>

#include <cmath>

namespace plumbline {

Screen Screen::ofCamera(const Camera& camera) {
    Screen screen;
    const Mat4 view = viewFromWorld(camera);
    screen.origin_ = camera.positionWorld;
    screen.right_ = Vec3(glm::row(view, 0));
    screen.down_ = -Vec3(glm::row(view, 1));
    screen.forward_ = -Vec3(glm::row(view, 2));
    screen.perspective_ = camera.projection == Camera::Projection::Perspective;
    screen.scale_ = camera.height / (screen.perspective_ ? 2 * std::tan(0.5 * radians(camera.fovYDegrees))
                                                         : camera.viewHeight);
    screen.center_ = 0.5 * Vec2(camera.width, camera.height);
    screen.viewpoint_ = {!screen.perspective_, screen.perspective_ ? screen.origin_ : -screen.forward_};
    return screen;
}

Screen Screen::ofDistantLight(const Vec3& toLight, const Vec3& center, double pixelWorld) {
    Screen screen;
    screen.perspective_ = false;
    screen.origin_ = center;
    screen.forward_ = -toLight;
    const Vec3 axis = std::abs(toLight.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    screen.right_ = glm::normalize(glm::cross(screen.forward_, axis));
    screen.down_ = glm::cross(screen.forward_, screen.right_);
    screen.scale_ = 1 / pixelWorld;
    screen.viewpoint_ = {true, toLight};
    return screen;
}

Screen Screen::ofCubeFace(const Vec3& light, int face, int size) {
    Screen screen;
    screen.origin_ = light;
    const int axis = face / 2;
    screen.forward_ = Vec3(0);
    screen.forward_[axis] = face % 2 ? -1 : 1;
    screen.right_ = Vec3(0);
    screen.right_[(axis + 1) % 3] = 1;
    screen.down_ = glm::cross(screen.forward_, screen.right_);
    screen.scale_ = 0.5 * size;
    screen.center_ = Vec2(0.5 * size);
    screen.viewpoint_ = {false, light};
    return screen;
}

Vec3 Screen::project(const Vec3& point) const {
    const Vec3 offset = point - origin_;
    const double depth = glm::dot(offset, forward_);
    const double pixels = perspective_ ? scale_ / depth : scale_;
    return {center_.x + glm::dot(offset, right_) * pixels, center_.y + glm::dot(offset, down_) * pixels,
            depth};
}

Vec3 Screen::projectHomogeneous(const Vec3& point) const {
    const Vec3 offset = point - origin_;
    const double w = perspective_ ? glm::dot(offset, forward_) : 1;
    return {center_.x * w + glm::dot(offset, right_) * scale_,
            center_.y * w + glm::dot(offset, down_) * scale_, w};
}

double Screen::pixelsPerWorld(const Vec3& p) const {
    if (!perspective_) return scale_;
    // The projection of a small ball off the axis is stretched by the reciprocal of the cosine of its angle.
    const Vec2 off = (Vec2(p) - center_) / scale_;
    return scale_ / p.z * std::sqrt(1 + glm::dot(off, off));
}

Vec3 Screen::unproject(const Vec3& p) const {
    const double world = (perspective_ ? p.z : 1) / scale_;
    return origin_ + forward_ * p.z + (right_ * (p.x - center_.x) + down_ * (p.y - center_.y)) * world;
}

} // namespace plumbline
