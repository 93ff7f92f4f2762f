// The names of the header fields of a frame's file: string attributes, Frame::metadata in memory.
//
// Whoever writes or reads one takes its name from here. Those of the scene are written and read by
// frame_header.h, those of its objects by object_info.h, those of a reference's error by certificate.h; each
// renderer adds its own.
#pragma once

#include <string>
#include <string_view>

namespace plumbline::header {

// Of the scene.
inline constexpr const char* kProgram = "program"; // name and version
inline constexpr const char* kScene = "scene";     // Scene::name
inline constexpr const char* kSceneHash = "scene_hash";
inline constexpr const char* kSceneChanges = "scene_changes"; // separated by ", "; only if there are any
/// One line: projection, position, target, up, field of view or view height, size in pixels.
inline constexpr const char* kCamera = "camera";
inline constexpr const char* kLights = "lights"; // names, separated by spaces, in the scene's order
/// light.<name>: "to_light x y z", direction toward it, world; or "position x y z", world.
inline constexpr std::string_view kLightPrefix = "light.";
inline std::string light(std::string_view name) {
    return std::string(kLightPrefix).append(name);
}

// Of an object: object.<id>.<field>, where <id> is the value of the frame's id channel, from 1.
inline constexpr std::string_view kObjectPrefix = "object.";
inline std::string object(int id, std::string_view field) {
    return std::string(kObjectPrefix).append(std::to_string(id)).append(".").append(field);
}
inline constexpr std::string_view kObjectName = "name";
// Only objects with a relief have these four.
inline constexpr std::string_view kReliefDepth = "relief_depth"; // world units
/// "x y z", unit, world: what the relief goes along; absent where that is the normal.
inline constexpr std::string_view kReliefAxis = "relief_axis";
inline constexpr std::string_view kMapTexels = "map_texels"; // "width height" of the relief map
inline constexpr std::string_view kMapWrap = "map_wrap";     // "repeat clamp": along s and t

// Of the renderer.
inline constexpr const char* kRenderer = "renderer"; // "reference" or "realtime"
inline constexpr const char* kBase = "base";         // baseName() in frame_header.h
// Of the reference.
inline constexpr const char* kMicroTriangles = "micro_triangles"; // how many
inline constexpr std::string_view kObjectRate = "rate";           // of an object: segments per control edge
/// certificate.<key>: its own error, the keys of certificate.h.
inline std::string certificate(std::string_view key) {
    return std::string("certificate.").append(key);
}
// Of a technique.
inline constexpr const char* kTechnique = "technique"; // Technique::name
inline std::string parameter(std::string_view name) {
    return std::string("parameter.").append(name);
}

} // namespace plumbline::header
