#include "scenes/scene_file/scene_camera.h"

#include "scenes/scene/camera_fault.h"
#include "scenes/scene/scene_limits.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace plumbline {
namespace {

constexpr int kLargestSide = 32768; // pixels
constexpr int64_t kMaxPixels = int64_t(1) << 28;

/// `orbit = { distance, polar_degrees, azimuth_degrees }`: spherical coordinates around the target, with the
/// polar angle measured from world +Y and the azimuth from +Z toward +X. The image's up is the direction of
/// decreasing polar angle, so that a view from straight above is no special case.
void readOrbit(const TomlTable& table, Camera& camera) {
    const TomlTable orbit = table.table("orbit");
    const double distance = orbit.number("distance", kSmallestLength, kLargestLength);
    const double polar = glm::radians(orbit.number("polar_degrees", 0, 180));
    const double azimuth = glm::radians(orbit.number("azimuth_degrees", -360, 360, 0.0));
    orbit.finish();
    const Vec3 level(std::sin(azimuth), 0, std::cos(azimuth));
    camera.positionWorld =
        camera.targetWorld + distance * (std::cos(polar) * Vec3(0, 1, 0) + std::sin(polar) * level);
    camera.upWorld = std::sin(polar) * Vec3(0, 1, 0) - std::cos(polar) * level;
    if (const auto fault = findPlaceFault("position", camera.positionWorld))
        table.fail("orbit", "gives an invalid camera position: it " + fault->found, fault->expected);
}

void readPlace(const TomlTable& table, Camera& camera) {
    camera.targetWorld = table.vector3("target", -kLargestLength, kLargestLength, Vec3(0));
    if (table.has("orbit")) {
        for (const char* key : {"position", "up"})
            if (table.has(key)) table.fail(key, "is given together with orbit", "one of the two");
        readOrbit(table, camera);
        return;
    }
    camera.positionWorld = table.vector3("position", -kLargestLength, kLargestLength);
    camera.upWorld = table.vector3("up", -kLargestLength, kLargestLength, Vec3(0, 1, 0));
}

void readProjection(const TomlTable& table, Camera& camera) {
    const std::string projection = table.choice("projection", {"perspective", "orthographic"}, "perspective");
    if (projection == "perspective") {
        camera.fovYDegrees =
            table.number("fov_y_degrees", kSmallestFovYDegrees, kLargestFovYDegrees, camera.fovYDegrees);
        if (table.has("view_height")) table.fail("view_height", "belongs to projection \"orthographic\"");
    } else {
        camera.projection = Camera::Projection::Orthographic;
        camera.viewHeight = table.number("view_height", kSmallestLength, kLargestLength, camera.viewHeight);
        if (table.has("fov_y_degrees")) table.fail("fov_y_degrees", "belongs to projection \"perspective\"");
    }
}

void readSize(const TomlTable& table, Camera& camera) {
    camera.width = table.integer("width", 1, kLargestSide, camera.width);
    camera.height = table.integer("height", 1, kLargestSide, camera.height);
    if (int64_t(camera.width) * camera.height > kMaxPixels)
        table.fail("width", fmt::format("{} x {} pixels are too many", camera.width, camera.height),
                   "at most 2^28");
}

} // namespace

Camera readCamera(const TomlTable& table) {
    Camera camera;
    readPlace(table, camera);
    readProjection(table, camera);
    readSize(table, camera);
    if (const auto fault = findFault(camera)) table.fail(fault->field, fault->found, fault->expected);
    table.finish();
    return camera;
}

} // namespace plumbline
