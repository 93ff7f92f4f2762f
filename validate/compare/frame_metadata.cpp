#include "validate/compare/frame_metadata.h"

#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "scenes/scene/camera_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace plumbline {
namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& key, const std::string& value,
                         const std::string& expected) {
    throw InputError(fmt::format("{}: header field '{}'", where, key),
                     fmt::format("'{}' can't be read", value), expected);
}

/// Words of a header value, taken one by one; any word that isn't what is asked for makes the value
/// unreadable.
class Words {
  public:
    explicit Words(const std::string& text) : stream_(text) { stream_.imbue(std::locale::classic()); }
    std::string word() {
        std::string next;
        if (!(stream_ >> next)) failed_ = true;
        return next;
    }
    void literal(const char* expected) { failed_ = word() != expected || failed_; }
    double number() {
        const std::optional<double> number = parseNumber<double>(word());
        if (!number) failed_ = true;
        return number.value_or(0);
    }
    int count(int largest) {
        const double value = number();
        if (!(value >= 1 && value <= largest) || value != std::floor(value)) {
            failed_ = true;
            return 1;
        }
        return static_cast<int>(value);
    }
    Vec3 vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    bool repeats() {
        const std::string wrap = word();
        if (wrap != "repeat" && wrap != "clamp") failed_ = true;
        return wrap == "repeat";
    }
    /// Whether everything was as asked for and nothing is left.
    bool ok() {
        std::string rest;
        return !failed_ && !(stream_ >> rest);
    }

  private:
    std::istringstream stream_;
    bool failed_ = false;
};

constexpr int kLargestMapSide = 1 << 24;
const std::string kLightPrefix = "light.";
constexpr int kLargestFrameSide = 1 << 24;

/// What was expected, where the field can't be read: it is unknown then.
std::optional<std::string> readObjectField(const std::string& field, const std::string& value,
                                           ObjectInfo& object) {
    Words words(value);
    if (field == "name") {
        object.name = value;
    } else if (field == "relief_depth") {
        object.reliefDepth = words.number();
        if (words.ok() && *object.reliefDepth >= 0) return std::nullopt;
        object.reliefDepth.reset();
        return "a number >= 0, world units";
    } else if (field == "map_texels") {
        const int width = words.count(kLargestMapSide), height = words.count(kLargestMapSide);
        if (!words.ok()) return "two whole numbers: width height";
        if (!object.map) object.map.emplace();
        object.map->width = width;
        object.map->height = height;
    } else if (field == "map_wrap") {
        const bool repeatS = words.repeats(), repeatT = words.repeats();
        if (!words.ok()) return "two words of: repeat clamp";
        if (!object.map) object.map.emplace();
        object.map->repeatS = repeatS;
        object.map->repeatT = repeatT;
    }
    return std::nullopt;
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
            info.map = ObjectInfo::Map{map.width(), map.height(), map.wrapS() == Wrap::Repeat,
                                       map.wrapT() == Wrap::Repeat};
        }
        objects.push_back(std::move(info));
    }
    return objects;
}

bool isPlumblines(const Frame& frame) {
    const auto program = frame.metadata.find("program");
    return program != frame.metadata.end() && program->second.starts_with("plumbline");
}

/// Appends the keys of fields of another program that can't be read to `leftOut`.
static std::vector<ObjectInfo> readObjects(const Frame& frame, const std::string& where,
                                           std::vector<std::string>& leftOut) {
    constexpr std::string_view kPrefix = "object.";
    std::map<int, ObjectInfo> byId;
    for (const auto& [key, value] : frame.metadata) {
        if (!key.starts_with(kPrefix)) continue;
        const size_t dot = key.find('.', kPrefix.size());
        if (dot == std::string::npos) continue; // somebody else's key
        const int id =
            parseNumber<int>(std::string_view(key).substr(kPrefix.size(), dot - kPrefix.size())).value_or(0);
        if (id < 1 || id > kLargestId) continue;
        const auto [entry, isNew] = byId.try_emplace(id);
        if (isNew) {
            entry->second.id = id;
            entry->second.name = fmt::format("object {}", id);
            entry->second.reliefDepth = 0; // a header that names an object says so where it has a relief
        }
        if (const auto expected = readObjectField(key.substr(dot + 1), value, entry->second)) {
            if (isPlumblines(frame)) refuse(where, key, value, *expected);
            leftOut.push_back(key);
        }
    }
    std::vector<ObjectInfo> objects;
    for (auto& [id, object] : byId) {
        if (object.map && object.map->width == 0) object.map.reset(); // wrap without a size
        objects.push_back(std::move(object));
    }
    return objects;
}

std::vector<ObjectInfo> objectsFromHeader(const Frame& frame, const std::string& where) {
    std::vector<std::string> leftOut;
    return readObjects(frame, where, leftOut);
}

std::optional<Camera> cameraFromHeader(const Frame& frame, const std::string& where) {
    const auto found = frame.metadata.find("camera");
    if (found == frame.metadata.end()) return std::nullopt;
    Words words(found->second);
    Camera camera;
    const std::string projection = words.word();
    const bool perspective = projection == "perspective";
    camera.projection = perspective ? Camera::Projection::Perspective : Camera::Projection::Orthographic;
    words.literal("position");
    camera.positionWorld = words.vector();
    words.literal("target");
    camera.targetWorld = words.vector();
    words.literal("up");
    camera.upWorld = words.vector();
    words.literal(perspective ? "fov_y_degrees" : "view_height");
    (perspective ? camera.fovYDegrees : camera.viewHeight) = words.number();
    words.literal("size");
    camera.width = words.count(kLargestFrameSide);
    camera.height = words.count(kLargestFrameSide);
    if (!words.ok() || (!perspective && projection != "orthographic")) {
        if (!isPlumblines(frame)) return std::nullopt; // somebody else's attribute
        refuse(where, "camera", found->second,
               "'perspective position x y z target x y z up x y z fov_y_degrees F size W H', or "
               "'orthographic' with 'view_height'");
    }
    const std::string field = fmt::format("{}: header field 'camera'", where);
    if (const auto fault = findFault(camera))
        throw InputError(field, fmt::format("{} {}", fault->field, fault->found), fault->expected);
    if (camera.width != frame.width() || camera.height != frame.height())
        throw InputError(field,
                         fmt::format("is of a picture of {} x {} pixels, the frame has {} x {}", camera.width,
                                     camera.height, frame.width(), frame.height()),
                         "the frame as it was rendered, neither cropped nor scaled");
    return camera;
}

std::vector<Light> lightsFromHeader(const Frame& frame, const std::string& where) {
    std::vector<Light> lights;
    for (const auto& [key, value] : frame.metadata) {
        if (!key.starts_with(kLightPrefix)) continue;
        Words words(value);
        const std::string kind = words.word();
        const Vec3 vector = words.vector();
        const bool point = kind == "position";
        if (!words.ok() || (!point && (kind != "to_light" || !(glm::length(vector) > 0)))) {
            if (!isPlumblines(frame)) continue; // somebody else's attribute
            refuse(where, key, value, "'to_light x y z', not zero, or 'position x y z'");
        }
        Light light;
        light.name = key.substr(kLightPrefix.size());
        light.kind = point ? Light::Kind::Point : Light::Kind::Directional;
        if (point)
            light.positionWorld = vector;
        else
            light.toLightWorld = glm::normalize(vector);
        lights.push_back(std::move(light));
    }
    return lights;
}

std::vector<std::string> leftOutFields(const Frame& frame, const std::string& where) {
    std::vector<std::string> fields;
    readObjects(frame, where, fields);
    if (frame.metadata.contains("camera") && !cameraFromHeader(frame, where)) fields.emplace_back("camera");
    const std::vector<Light> lights = lightsFromHeader(frame, where);
    for (const std::string& name : frame.lightNames())
        if (frame.metadata.contains(kLightPrefix + name) &&
            std::none_of(lights.begin(), lights.end(),
                         [&](const Light& light) { return light.name == name; }))
            fields.push_back(kLightPrefix + name);
    return fields;
}

CertificateSummary certificateFromHeader(const Frame& frame, const std::string& where) {
    const std::string prefix = "certificate.";
    CertificateSummary certificate;
    for (const CertificateFigure& entry : certificateFigures()) {
        const std::string key = prefix + entry.key;
        const auto found = frame.metadata.find(key);
        if (found == frame.metadata.end()) {
            certificate.*entry.figure =
                Figure::absent(fmt::format("the reference's file has no header field {}", key));
            continue;
        }
        Words words(found->second);
        const double value = words.number();
        if (!words.ok() || value < 0) refuse(where, key, found->second, "a number >= 0");
        certificate.*entry.figure = value;
    }
    const std::string limitKey = prefix + "error_limit";
    if (const auto found = frame.metadata.find(limitKey); found != frame.metadata.end())
        certificate.limit = found->second;
    else
        certificate.limitReason = fmt::format("the reference's file has no header field {}", limitKey);
    countPixels(frame, certificate);
    return certificate;
}

} // namespace plumbline
