#include "scenes/frame/object_info.h"

#include "scenes/core/numbers.h"
#include "scenes/frame/frame.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/header_fields.h"
#include "scenes/frame/header_words.h"
#include "scenes/scene/scene.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace plumbline {
namespace {

constexpr int kLargestMapSide = 1 << 24;
constexpr const char* kRepeat = "repeat";
constexpr const char* kClamp = "clamp";

const char* wrapText(bool repeats) {
    return repeats ? kRepeat : kClamp;
}

/// What was expected, where the field can't be read: it is unknown then.
std::optional<std::string> readObjectField(std::string_view field, const std::string& value,
                                           ObjectInfo& object) {
    HeaderWords words(value);
    if (field == header::kObjectName) {
        object.name = value;
    } else if (field == header::kReliefDepth) {
        object.reliefDepth = words.number();
        if (words.ok() && *object.reliefDepth >= 0) return std::nullopt;
        object.reliefDepth.reset();
        return "a number >= 0, world units";
    } else if (field == header::kReliefAxis) {
        const Vec3 axis = words.vector();
        if (!words.ok()) return "three numbers: x y z";
        object.reliefAxisWorld = axis;
    } else if (field == header::kMapTexels) {
        const int width = words.count(kLargestMapSide), height = words.count(kLargestMapSide);
        if (!words.ok()) return "two whole numbers: width height";
        if (!object.map) object.map = ObjectInfo::Map();
        object.map->width = width;
        object.map->height = height;
    } else if (field == header::kMapWrap) {
        const bool repeatS = words.either(kRepeat, kClamp), repeatT = words.either(kRepeat, kClamp);
        if (!words.ok()) return "two words of: repeat clamp";
        if (!object.map) object.map = ObjectInfo::Map();
        object.map->repeatS = repeatS;
        object.map->repeatT = repeatT;
    }
    return std::nullopt;
}

/// The id and the field of a key object.<id>.<field>; nullopt for any other key.
std::optional<std::pair<int, std::string_view>> splitKey(std::string_view key) {
    if (!key.starts_with(header::kObjectPrefix)) return std::nullopt;
    key.remove_prefix(header::kObjectPrefix.size());
    const size_t dot = key.find('.');
    if (dot == std::string_view::npos) return std::nullopt;
    const int id = parseNumber<int>(key.substr(0, dot)).value_or(0);
    if (id < 1 || id > kLargestId) return std::nullopt;
    return std::pair(id, key.substr(dot + 1));
}

} // namespace

std::vector<ObjectInfo> objectsOf(const Scene& scene) {
    std::vector<ObjectInfo> objects;
    for (const SceneObject& object : scene.objects) {
        ObjectInfo info;
        info.id = static_cast<int>(objects.size()) + 1;
        info.name = object.name;
        info.reliefDepth = 0;
        if (object.relief) {
            const HeightMap& map = *object.relief->map;
            info.reliefDepth = object.relief->depth;
            info.reliefAxisWorld = object.relief->axisWorld;
            info.map = ObjectInfo::Map{map.width(), map.height(), map.wrapS() == Wrap::Repeat,
                                       map.wrapT() == Wrap::Repeat};
        }
        objects.push_back(std::move(info));
    }
    return objects;
}

void writeObjects(const std::vector<ObjectInfo>& objects, std::map<std::string, std::string>& metadata) {
    for (const ObjectInfo& object : objects) {
        metadata[header::object(object.id, header::kObjectName)] = object.name;
        if (!object.map) continue; // no relief
        const auto field = [&](std::string_view name) -> std::string& {
            return metadata[header::object(object.id, name)];
        };
        if (object.reliefDepth) field(header::kReliefDepth) = fmt::format("{}", *object.reliefDepth);
        if (object.reliefAxisWorld) field(header::kReliefAxis) = headerText(*object.reliefAxisWorld);
        field(header::kMapTexels) = fmt::format("{} {}", object.map->width, object.map->height);
        field(header::kMapWrap) =
            fmt::format("{} {}", wrapText(object.map->repeatS), wrapText(object.map->repeatT));
    }
}

std::vector<ObjectInfo> objectsFromHeader(const Frame& frame, const std::string& where,
                                          std::vector<std::string>* leftOut) {
    std::map<int, ObjectInfo> byId;
    for (const auto& [key, value] : frame.metadata) {
        const auto split = splitKey(key);
        if (!split) continue; // somebody else's key
        const auto [id, field] = *split;
        const auto [entry, isNew] = byId.try_emplace(id);
        if (isNew) {
            entry->second.id = id;
            entry->second.name = fmt::format("object {}", id);
            entry->second.reliefDepth = 0; // a header that names an object says so where it has a relief
        }
        if (const auto expected = readObjectField(field, value, entry->second)) {
            if (isPlumblines(frame)) refuseHeaderField(where, key, value, *expected);
            if (leftOut) leftOut->push_back(key);
        }
    }
    std::vector<ObjectInfo> objects;
    for (auto& [id, object] : byId) {
        if (object.map && object.map->width == 0) object.map.reset(); // wrap without a size
        objects.push_back(std::move(object));
    }
    return objects;
}

} // namespace plumbline
