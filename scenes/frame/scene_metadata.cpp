#include "scenes/frame/scene_metadata.h"

#include <fmt/format.h>

namespace plumbline {

namespace {

std::string text(const Vec3& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

const char* nameOf(Wrap wrap) {
    return wrap == Wrap::Repeat ? "repeat" : "clamp";
}

std::string describe(const Camera& camera) {
    const bool perspective = camera.projection == Camera::Projection::Perspective;
    return fmt::format("{} position {} target {} up {} {} {} size {} {}",
                       perspective ? "perspective" : "orthographic", text(camera.positionWorld),
                       text(camera.targetWorld), text(camera.upWorld),
                       perspective ? "fov_y_degrees" : "view_height",
                       perspective ? camera.fovYDegrees : camera.viewHeight, camera.width, camera.height);
}

} // namespace

std::string programName() {
    return "plumbline " PLUMBLINE_VERSION;
}

std::map<std::string, std::string> sceneMetadata(const Scene& scene) {
    std::map<std::string, std::string> metadata{{"program", programName()},
                                                {"scene", scene.name},
                                                {"scene_hash", scene.hash},
                                                {"camera", describe(scene.camera)}};
    if (!scene.changes.empty()) metadata["scene_changes"] = fmt::format("{}", fmt::join(scene.changes, ", "));
    std::string lights;
    for (const Light& light : scene.lights) {
        lights += (lights.empty() ? "" : " ") + light.name;
        metadata["light." + light.name] = light.kind == Light::Kind::Point
                                              ? "position " + text(light.positionWorld)
                                              : "to_light " + text(light.toLightWorld);
    }
    metadata["lights"] = lights;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        const std::string key = fmt::format("object.{}.", i + 1);
        metadata[key + "name"] = object.name;
        if (!object.relief) continue;
        metadata[key + "relief_depth"] = fmt::format("{}", object.relief->depth);
        if (object.relief->axisWorld) metadata[key + "relief_axis"] = text(*object.relief->axisWorld);
        metadata[key + "map_texels"] =
            fmt::format("{} {}", object.relief->map->width(), object.relief->map->height());
        metadata[key + "map_wrap"] =
            fmt::format("{} {}", nameOf(object.relief->map->wrapS()), nameOf(object.relief->map->wrapT()));
    }
    return metadata;
}

} // namespace plumbline
