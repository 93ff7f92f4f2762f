// What a frame's header says of the objects the frame shows; with the frames, all that metrics know of a
// scene's objects.
#pragma once

#include "scenes/core/math.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

class Frame;
struct Scene;

/// More than any scene has; above it a plane `id` is a hash, not the number of an object.
inline constexpr int kLargestId = 65535;

struct ObjectInfo {
    int id = 0; // value of the `id` channel
    std::string name;
    std::optional<double> reliefDepth;   // world units; 0: no relief; nullopt: not known
    std::optional<Vec3> reliefAxisWorld; // unit, what the relief goes along; nullopt: the normal
    /// Texels of its height map, nullopt: not known or no relief.
    struct Map {
        int width = 0, height = 0;
        bool repeatS = true, repeatT = true;
        bool operator==(const Map&) const = default;
    };
    std::optional<Map> map;

    bool hasRelief() const { return !reliefDepth || *reliefDepth > 0; } // an unknown one may well have one
    bool operator==(const ObjectInfo&) const = default;
};

/// Those of a scene; ids as in its frames.
std::vector<ObjectInfo> objectsOf(const Scene& scene);

/// The header fields object.<id>.… of a scene's objects.
void writeObjects(const std::vector<ObjectInfo>& objects, std::map<std::string, std::string>& metadata);

/// The objects that a frame's header names; empty if it names none. Throws InputError, with `where` in front,
/// for a value of this program's that can't be read; another's is left out, its key added to `leftOut`.
std::vector<ObjectInfo> objectsFromHeader(const Frame& frame, const std::string& where,
                                          std::vector<std::string>* leftOut = nullptr);

} // namespace plumbline
