#include "scenes/frame/frame_header.h"

#include "scenes/core/error.h"
#include "scenes/core/program_name.h"
#include "scenes/frame/header_fields.h"
#include "scenes/frame/header_words.h"
#include "scenes/frame/object_info.h"
#include "scenes/scene/camera_fault.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plumbline {
namespace {

constexpr int kLargestFrameSide = 1 << 24;

constexpr const char* kPerspective = "perspective";
constexpr const char* kOrthographic = "orthographic";
constexpr const char* kToLight = "to_light";
constexpr const char* kPosition = "position"; // of a camera or a light

const char* openingName(bool perspective) {
    return perspective ? "fov_y_degrees" : "view_height";
}

std::string cameraText(const Camera& camera) {
    const bool perspective = camera.projection == Camera::Projection::Perspective;
    return fmt::format("{} {} {} target {} up {} {} {} size {} {}",
                       perspective ? kPerspective : kOrthographic, kPosition,
                       headerText(camera.positionWorld), headerText(camera.targetWorld),
                       headerText(camera.upWorld), openingName(perspective),
                       perspective ? camera.fovYDegrees : camera.viewHeight, camera.width, camera.height);
}

/// nullopt if the text isn't as cameraText() writes it.
std::optional<Camera> parseCamera(const std::string& text) {
    HeaderWords words(text);
    Camera camera;
    const bool perspective = words.either(kPerspective, kOrthographic);
    camera.projection = perspective ? Camera::Projection::Perspective : Camera::Projection::Orthographic;
    words.literal(kPosition);
    camera.positionWorld = words.vector();
    words.literal("target");
    camera.targetWorld = words.vector();
    words.literal("up");
    camera.upWorld = words.vector();
    words.literal(openingName(perspective));
    (perspective ? camera.fovYDegrees : camera.viewHeight) = words.number();
    words.literal("size");
    camera.width = words.count(kLargestFrameSide);
    camera.height = words.count(kLargestFrameSide);
    if (!words.ok()) return std::nullopt;
    return camera;
}

std::string lightText(const Light& light) {
    return light.kind == Light::Kind::Point ? fmt::format("{} {}", kPosition, headerText(light.positionWorld))
                                            : fmt::format("{} {}", kToLight, headerText(light.toLightWorld));
}

/// nullopt if the text isn't as lightText() writes it, or is no direction.
std::optional<Light> parseLight(std::string_view name, const std::string& text) {
    HeaderWords words(text);
    Light light;
    light.name = name;
    const bool point = words.either(kPosition, kToLight);
    const Vec3 vector = words.vector();
    if (!words.ok() || (!point && !(glm::length(vector) > 0))) return std::nullopt;
    light.kind = point ? Light::Kind::Point : Light::Kind::Directional;
    (point ? light.positionWorld : light.toLightWorld) = point ? vector : glm::normalize(vector);
    return light;
}

void writeLights(const std::vector<Light>& lights, std::map<std::string, std::string>& metadata) {
    std::string names;
    for (const Light& light : lights) {
        names += (names.empty() ? "" : " ") + light.name;
        metadata[header::light(light.name)] = lightText(light);
    }
    metadata[header::kLights] = names;
}

} // namespace

std::map<std::string, std::string> sceneMetadata(const Scene& scene) {
    std::map<std::string, std::string> metadata{{header::kProgram, programName()},
                                                {header::kScene, scene.name},
                                                {header::kSceneHash, scene.hash},
                                                {header::kCamera, cameraText(scene.camera)}};
    if (!scene.changes.empty())
        metadata[header::kSceneChanges] = fmt::format("{}", fmt::join(scene.changes, ", "));
    writeLights(scene.lights, metadata);
    writeObjects(objectsOf(scene), metadata);
    return metadata;
}

const char* baseName(Base base) {
    return base == Base::Proxy ? "proxy" : "limit";
}

bool isPlumblines(const Frame& frame) {
    return headerField(frame, header::kProgram).starts_with("plumbline");
}

std::string headerField(const Frame& frame, const std::string& key, const std::string& otherwise) {
    const auto found = frame.metadata.find(key);
    return found == frame.metadata.end() ? otherwise : found->second;
}

std::optional<Camera> cameraFromHeader(const Frame& frame, const std::string& where) {
    const auto found = frame.metadata.find(header::kCamera);
    if (found == frame.metadata.end()) return std::nullopt;
    const std::optional<Camera> camera = parseCamera(found->second);
    if (!camera) {
        if (!isPlumblines(frame)) return std::nullopt; // somebody else's attribute
        refuseHeaderField(where, header::kCamera, found->second,
                          "'perspective position x y z target x y z up x y z fov_y_degrees F size W H', or "
                          "'orthographic' with 'view_height'");
    }
    const std::string field = fmt::format("{}: header field '{}'", where, header::kCamera);
    if (const auto fault = findFault(*camera))
        throw InputError(field, fmt::format("{} {}", fault->field, fault->found), fault->expected);
    if (camera->width != frame.width() || camera->height != frame.height())
        throw InputError(field,
                         fmt::format("is of a picture of {} x {} pixels, the frame has {} x {}",
                                     camera->width, camera->height, frame.width(), frame.height()),
                         "the frame as it was rendered, neither cropped nor scaled");
    return camera;
}

std::vector<Light> lightsFromHeader(const Frame& frame, const std::string& where) {
    std::vector<Light> lights;
    for (const auto& [key, value] : frame.metadata) {
        if (!key.starts_with(header::kLightPrefix)) continue;
        const std::string_view name = std::string_view(key).substr(header::kLightPrefix.size());
        if (std::optional<Light> light = parseLight(name, value))
            lights.push_back(std::move(*light));
        else if (isPlumblines(frame)) // or else somebody else's attribute
            refuseHeaderField(where, key, value, "'to_light x y z', not zero, or 'position x y z'");
    }
    return lights;
}

std::vector<std::string> leftOutFields(const Frame& frame, const std::string& where) {
    std::vector<std::string> fields;
    objectsFromHeader(frame, where, &fields);
    if (frame.metadata.contains(header::kCamera) && !cameraFromHeader(frame, where))
        fields.emplace_back(header::kCamera);
    const std::vector<Light> lights = lightsFromHeader(frame, where);
    for (const std::string& name : frame.lightNames())
        if (frame.metadata.contains(header::light(name)) &&
            std::ranges::find(lights, name, &Light::name) == lights.end())
            fields.push_back(header::light(name));
    return fields;
}

} // namespace plumbline
