#include "scenes/scene/camera_fault.h"

#include "scenes/scene/scene_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plumbline {
namespace {

// Below this sine of the angle between view direction and up, the picture's roll is rounding noise.
constexpr double kSmallestUpSine = 1e-6;

std::optional<CameraFault> findRangeFault(const char* field, double value, double low, double high) {
    if (value >= low && value <= high) return std::nullopt;
    return CameraFault{field, fmt::format("is {}", value), fmt::format("{} to {}", low, high)};
}

std::optional<CameraFault> findAxesFault(const Camera& camera) {
    const Vec3 view = camera.targetWorld - camera.positionWorld;
    const double magnitude = std::max(glm::length(camera.positionWorld), glm::length(camera.targetWorld));
    // Closer than that, the direction is made of the coordinates' last digits.
    if (glm::length(view) <= 1e-12 * magnitude || !(glm::length(view) > 0))
        return CameraFault{"target", "is where the camera is", "another place than position"};
    if (!(glm::length(camera.upWorld) > 0)) return CameraFault{"up", "is zero", "a direction"};
    if (glm::length(glm::cross(glm::normalize(view), glm::normalize(camera.upWorld))) < kSmallestUpSine)
        return CameraFault{"up", "is parallel to the view direction", "a direction that points elsewhere"};
    return std::nullopt;
}

} // namespace

std::optional<CameraFault> findPlaceFault(const char* field, const Vec3& place) {
    for (int axis = 0; axis < 3; ++axis)
        if (auto fault = findRangeFault(field, place[axis], -kLargestLength, kLargestLength)) return fault;
    return std::nullopt;
}

std::optional<CameraFault> findFault(const Camera& camera) {
    for (const auto& [field, place] : {std::pair("position", camera.positionWorld),
                                       {"target", camera.targetWorld},
                                       {"up", camera.upWorld}})
        if (auto fault = findPlaceFault(field, place)) return fault;
    const bool perspective = camera.projection == Camera::Projection::Perspective;
    if (auto fault = perspective
                         ? findRangeFault("fov_y_degrees", camera.fovYDegrees, kSmallestFovYDegrees,
                                          kLargestFovYDegrees)
                         : findRangeFault("view_height", camera.viewHeight, kSmallestLength, kLargestLength))
        return fault;
    return findAxesFault(camera);
}

} // namespace plumbline
