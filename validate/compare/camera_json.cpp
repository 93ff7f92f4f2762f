#include "validate/compare/camera_json.h"

#include "scenes/core/program_name.h"

#include <nlohmann/json.hpp>

namespace plumbline {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Vec3& v) {
    return {v.x, v.y, v.z};
}

Json rowsOf(const Mat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
    return rows;
}

Json toJson(const Light& light) {
    if (light.kind == Light::Kind::Directional)
        return {{"name", light.name}, {"kind", "directional"}, {"to_light", toJson(light.toLightWorld)}};
    return {{"name", light.name}, {"kind", "point"}, {"position", toJson(light.positionWorld)}};
}

void addCamera(const Camera& camera, Json& json) {
    json["width"] = camera.width;
    json["height"] = camera.height;
    json["aspect"] = static_cast<double>(camera.width) / camera.height;
    const bool perspective = camera.projection == Camera::Projection::Perspective;
    json["projection"] = perspective ? "perspective" : "orthographic";
    json[perspective ? "fov_y_degrees" : "view_height"] =
        perspective ? camera.fovYDegrees : camera.viewHeight;
    json["position"] = toJson(camera.positionWorld);
    json["target"] = toJson(camera.targetWorld);
    json["up"] = toJson(camera.upWorld);
    json["world_to_view"] = rowsOf(viewFromWorld(camera));
    json["view_to_world"] = rowsOf(glm::inverse(viewFromWorld(camera)));
}

} // namespace

std::string cameraJson(const Scene& scene) {
    Json json{{"program", programName()}, {"scene", scene.name}, {"scene_hash", scene.hash}};
    json["conventions"] =
        "World: right-handed, Y up. View: the camera looks down -Z, +Y up. Matrices: rows, for column "
        "vectors. Pixels: square, (0,0) top left, a pixel is the ray through its center.";
    addCamera(scene.camera, json);
    json["background"] = toJson(scene.background);
    json["lights"] = Json::array();
    for (const Light& light : scene.lights)
        json["lights"].push_back(toJson(light));
    json["objects"] = Json::array();
    for (size_t k = 0; k < scene.objects.size(); ++k) {
        const SceneObject& object = scene.objects[k];
        Json entry{{"name", object.name}, {"id", k + 1}, {"color", toJson(object.color)}};
        if (object.relief) entry["relief_depth"] = object.relief->depth;
        json["objects"].push_back(std::move(entry));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plumbline
