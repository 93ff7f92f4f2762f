// A scene in memory: plain structs with sensible defaults. scene_file.h reads one from TOML.
// World space: right-handed, Y up, world units.
#pragma once

#include "scenes/maps/height_map.h"
#include "scenes/mesh/control_mesh.h"
#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Linear RGB picture, row 0 = bottom, sampled bilinearly with repeat at st, like the relief.
struct ColorMap {
    std::string name;
    int width = 0, height = 0;
    std::vector<float> rgb; // width x height x 3, linear

    Vec3 sample(const Vec2& st) const;
};

/// What the relief stands on: the limit surface of the control mesh, or the polygon proxy that real-time
/// techniques are given (proxy_mesh.h).
enum class Base { Limit, Proxy };

/// Faces that meet in an edge may disagree about its displacement, where texture coordinates jump or a crease
/// has two normals. Weld: the mean of both, the surface stays closed. Open: each face keeps its own, the
/// surface gapes.
enum class Seams { Weld, Open };

/// P = S + k * (offset - depth * d(st)), st = tile * uv + uvOffset, k the surface's unit normal n(u,v) or one
/// axis for all of it.
struct Relief {
    std::shared_ptr<const HeightMap> map; // never null; `constant` in the file becomes a 1x1 map
    double depth = 0;                     // world units, >= 0
    double offset = 0;                    // world units
    Vec2 tile{1, 1};
    Vec2 uvOffset{0, 0};
    Seams seams = Seams::Weld;
    std::optional<Vec3> axisWorld{}; // k, unit; none: along the normal
};

struct SceneObject {
    std::string name;
    ControlMesh mesh; // object space
    Scheme scheme = Scheme::CatmullClark;
    int proxyRate = 1;                        // segments of the proxy per control edge
    Vec3 translate{0, 0, 0};                  // world units
    Vec3 rotateDegrees{0, 0, 0};              // about x, then y, then z
    double scale = 1;                         // > 0
    std::optional<Relief> relief;             // none: drawn as it is
    Vec3 color{0.8, 0.8, 0.8};                // linear
    std::shared_ptr<const ColorMap> colorMap; // null: `color`

    Mat4 worldFromObject() const;
    /// The object's own +z in world space, unit: turned, not scaled.
    Vec3 axisWorld() const;
    /// The mesh with points and normals in world space.
    ControlMesh meshWorld() const;
    /// Colour of the surface at st, linear.
    Vec3 colorAt(const Vec2& st) const { return colorMap ? colorMap->sample(st) : color; }
};

/// What techniques must reach on a scene: validate/results/requirement.h reads the text.
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
    std::vector<std::string>
        warnings; // a line each: what a user should know of meshes and maps before trusting figures
    std::vector<std::filesystem::path> files; // read: the scene file, meshes and maps
    std::string hash; // of what the scene file says (changes made, [require] left out) and every file it
                      // names; hexadecimal
    std::vector<std::string>
        changes; // fields that were given other values than the file's: "camera.width=400"
};

/// The one shading formula: colour * (0.05 + sum over lights of max(N.L, 0) * (1 - shadow)).
/// GLSL twin: shadeLinear in realtime/shaders/shading.glsl.
inline constexpr double kAmbient = 0.05;

} // namespace plumbline
