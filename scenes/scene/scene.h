// A scene as plain structs with defaults. scene_file.h reads it from TOML. World space: right-handed, Y up,
// world units.
#pragma once

#include "scenes/maps/color_map.h"
#include "scenes/mesh/control_mesh.h"
#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"
#include "scenes/scene/relief.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// The base surface of the relief: the limit surface of the control mesh, or the polygon proxy that real-time
/// techniques draw (proxy_mesh.h).
enum class Base { Limit, Proxy };

/// Whether the camera sees an object's back sides, those its faces turn away from. Either way, both sides
/// receive light and cast shadows.
///
/// Auto: the reference shows them; techniques draw them too, unless the mesh is closed and its fronts hide
/// them from the camera. Back: they are transparent, for reference and techniques. None: both draw them.
enum class Cull { Auto, Back, None };

struct SceneObject {
    std::string name;
    ControlMesh mesh; // object space
    Scheme scheme = Scheme::CatmullClark;
    int proxyRate = 1;           // segments of the proxy per control edge
    Vec3 translate{0, 0, 0};     // world units
    Vec3 rotateDegrees{0, 0, 0}; // about x, then y, then z
    double scale = 1;            // > 0
    Cull cull = Cull::Auto;
    std::optional<Relief> relief;             // none: not displaced
    Vec3 color{0.8, 0.8, 0.8};                // linear
    std::shared_ptr<const ColorMap> colorMap; // null: `color`

    /// The object's +z axis in world space, unit: rotated, not scaled.
    Vec3 axisWorld() const;
    /// The mesh with points and normals in world space.
    ControlMesh meshWorld() const;
    /// Color of the surface at st, linear.
    Vec3 colorAt(const Vec2& st) const { return colorMap ? colorMap->sample(st) : color; }
};

/// A bound that techniques must satisfy on a scene; validate/results/requirement.h parses the text.
struct SceneRequirement {
    std::string text;  // "silhouette.iou >= 0.99"
    std::string where; // "file:line: field", for messages
};

struct Scene {
    std::string name; // file stem
    std::string purpose;
    Vec3 background{0, 0, 0}; // linear
    Camera camera;
    std::vector<Light> lights;
    std::vector<SceneObject> objects;
    std::vector<SceneRequirement> requirements;
    /// Problems with meshes and maps that may affect results, one line each.
    std::vector<std::string> warnings;
    /// Files that were read: the scene file, meshes and maps.
    std::vector<std::filesystem::path> files;
    /// Hexadecimal hash of the scene file's values (with overrides, without [require]) and of all files it
    /// names.
    std::string hash;
    /// Overridden fields: "camera.width=400".
    std::vector<std::string> changes;
};

/// The shading formula: color * (0.05 + sum over lights of max(N.L, 0) * (1 - shadow)).
/// GLSL version: writePoint in realtime/shaders/shading.glsl.
inline constexpr double kAmbient = 0.05;

} // namespace plumbline
