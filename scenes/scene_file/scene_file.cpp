#include "scenes/scene_file/scene_file.h"

#include "scenes/core/contains.h"
#include "scenes/core/content_hash.h"
#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/maps/generate_map.h"
#include "scenes/maps/map_file.h"
#include "scenes/mesh/mesh_defects.h"
#include "scenes/mesh/obj_file.h"
#include "scenes/scene/scene_limits.h"
#include "scenes/scene_file/scene_camera.h"
#include "scenes/scene_file/scene_creases.h"
#include "scenes/scene_file/scene_merge.h"
#include "scenes/scene_file/scene_shape.h"
#include "scenes/surface/limit_check.h"
#include "scenes/toml/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plumbline {
namespace {

constexpr size_t kMaxLights = 16;
constexpr size_t kMaxObjects = 4096;
constexpr double kLargestTile = 1e6;
constexpr double kSmallestTile = 1e-6;
constexpr std::string_view kRequire = "require";

class SceneReader {
  public:
    explicit SceneReader(const std::filesystem::path& file) : file_(file), root_(TomlTable::readFile(file)) {}
    SceneReader(const std::filesystem::path& file, const std::string& text)
        : file_(file), root_(TomlTable::parse(file.string(), text)) {}

    void change(const std::string& text) {
        const std::string where = "--scene-set " + text;
        const size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw InputError(where, "has no '='", "PATH=VALUE, for example camera.width=400");
        root_.change(where, text.substr(0, equals), text.substr(equals + 1));
        scene_.changes.push_back(text);
    }

    Scene read() {
        scene_.name = file_.stem().string();
        scene_.files = {file_};
        scene_.purpose = readPurpose();
        root_.addTo(hash_, kRequire); // requirements don't affect the rendering
        scene_.background = root_.vector3("background", 0, 1, Vec3(0));
        scene_.camera = readCamera(root_.table("camera"));
        readLights();
        for (const TomlTable& map : root_.tables("height_map"))
            readMap(map);
        readObjects();
        readRequirements();
        root_.finish();
        scene_.hash = hash_.hexadecimal();
        return std::move(scene_);
    }

    /// Must be called after read().
    std::shared_ptr<const HeightMap> mapNamed(const std::string& name) const {
        const auto found = maps_.find(name);
        if (found != maps_.end()) return found->second;
        const std::vector<std::string> names(mapNames_.begin(), mapNames_.end());
        throw InputError(file_.string(), fmt::format("no height map of the scene is called \"{}\"", name),
                         names.empty() ? "a scene with a [[height_map]]" : listOf(names),
                         didYouMean(name, names));
    }

  private:
    std::string readPurpose() const {
        std::string purpose = root_.text("purpose");
        if (purpose.find_first_not_of(" \t\n") == std::string::npos)
            root_.fail("purpose", "is empty", "a sentence that states the purpose of the scene");
        return purpose;
    }

    void readLights() {
        std::set<std::string> names;
        const std::vector<TomlTable> tables = root_.tables("light");
        if (tables.size() > kMaxLights)
            tables[kMaxLights].fail({}, fmt::format("is one of {} lights", tables.size()),
                                    fmt::format("at most {}", kMaxLights));
        for (const TomlTable& table : tables) {
            Light light;
            light.name = table.name(names);
            if (table.has("to_light") == table.has("position"))
                table.fail({},
                           table.has("position") ? "has both to_light and position"
                                                 : "has neither to_light nor position",
                           "to_light (a distant light) or position (a near one)");
            if (table.has("position")) {
                light.kind = Light::Kind::Point;
                light.positionWorld = table.vector3("position", -kLargestLength, kLargestLength);
            } else {
                const Vec3 direction = table.vector3("to_light", -kLargestLength, kLargestLength);
                if (!(glm::length(direction) > 0)) table.fail("to_light", "is zero", "a direction");
                light.toLightWorld = glm::normalize(direction);
            }
            table.finish();
            scene_.lights.push_back(light);
        }
    }

    /// Paths in the scene file are relative to its folder.
    std::filesystem::path readPath(const TomlTable& table, const char* key) {
        const std::string text = table.text(key);
        if (text.empty()) table.fail(key, "is empty", "a file");
        std::filesystem::path path = (file_.parent_path() / text).lexically_normal();
        std::error_code error;
        if (!std::filesystem::exists(path, error))
            table.fail(key, fmt::format("no such file as '{}'", path.string()),
                       "a path relative to the scene file's folder");
        try {
            hash_.addFile(path);
        } catch (const InputError& problem) {
            table.fail(key, problem.what());
        }
        scene_.files.push_back(path);
        return path;
    }

    void readMap(const TomlTable& table) {
        const std::string name = table.name(mapNames_);
        const std::vector<std::string> wraps{"repeat", "clamp"};
        const std::vector<std::string> wrap =
            table.texts("wrap", std::vector<std::string>{"repeat", "repeat"});
        for (const std::string& w : wrap)
            if (!contains(wraps, w))
                table.fail("wrap", fmt::format("is \"{}\"", w), listOf(wraps), didYouMean(w, wraps));
        if (wrap.size() != 2)
            table.fail("wrap", fmt::format("has {} entries", wrap.size()), "two: along s and along t");
        const Wrap wrapS = wrap[0] == "repeat" ? Wrap::Repeat : Wrap::Clamp;
        const Wrap wrapT = wrap[1] == "repeat" ? Wrap::Repeat : Wrap::Clamp;
        if (table.has("file") == table.has("generate"))
            table.fail({}, table.has("file") ? "has both file and generate" : "has neither file nor generate",
                       "file or generate");
        maps_[name] = std::make_shared<const HeightMap>(
            table.has("file") ? readPictureMap(table, wrapS, wrapT) : readGeneratedMap(table, wrapS, wrapT));
        if (const HeightMap& map = *maps_[name]; map.minDepth() == map.maxDepth())
            scene_.warnings.push_back(
                fmt::format("height_map {}: {} is constant, with the depth {}: its relief has no detail",
                            name, map.name(), map.minDepth()));
        table.finish();
    }

    HeightMap readPictureMap(const TomlTable& table, Wrap wrapS, Wrap wrapT) {
        const bool depth = table.choice("stores", {"height", "depth"}) == "depth";
        return readHeightMap(readPath(table, "file"), depth ? Stores::Depth : Stores::Height, wrapS, wrapT);
    }

    HeightMap readGeneratedMap(const TomlTable& table, Wrap wrapS, Wrap wrapT) const {
        if (table.choice("stores", {"height", "depth"}, "depth") != "depth")
            table.fail("stores", "is \"height\"", "\"depth\" or nothing: generated maps are depths");
        const TomlTable generate = table.table("generate");
        const std::string kind = generate.choice("kind", generatedMapKinds());
        const int size = generate.integer("size", 1, kMaxGeneratedTexels, 256);
        const int seed = generate.integer("seed", 0, std::numeric_limits<int>::max(), 1);
        generate.finish();
        try {
            return generateMap(kind, size, static_cast<unsigned>(seed), wrapS, wrapT);
        } catch (const InputError& error) {
            generate.fail({}, error.what());
        }
    }

    void readObjects() {
        const std::vector<TomlTable> tables = root_.tables("object");
        if (tables.empty()) root_.fail("object", "is missing", "at least one [[object]]");
        if (tables.size() > kMaxObjects)
            tables[kMaxObjects].fail({}, fmt::format("is one of {} objects", tables.size()),
                                     fmt::format("at most {}", kMaxObjects));
        std::set<std::string> names;
        for (const TomlTable& table : tables) {
            SceneObject object;
            object.name = table.name(names);
            readSurface(table, object);
            readPlacement(table, object);
            if (table.has("relief")) readRelief(table, object);
            readColor(table, object);
            table.finish();
            checkSurface(table, object);
            for (const std::string& warning : meshWarnings(object.mesh, object.scheme))
                scene_.warnings.push_back(object.name + ": " + warning);
            // Polygons without a relief look the same either way.
            if (table.has("mesh") && (object.relief || object.scheme != Scheme::None))
                if (const auto warning = looseFacesWarning(object.mesh))
                    scene_.warnings.push_back(object.name + ": " + *warning);
            scene_.objects.push_back(std::move(object));
        }
    }

    void readSurface(const TomlTable& table, SceneObject& object) {
        const std::string scheme = table.choice("scheme", {"catmull-clark", "loop", "none"}, "catmull-clark");
        object.scheme = scheme == "loop"   ? Scheme::Loop
                        : scheme == "none" ? Scheme::None
                                           : Scheme::CatmullClark;
        object.proxyRate = table.integer("proxy_rate", 1, kMaxProxyRate, 1);
        const std::string cull = table.choice("cull", {"auto", "back", "none"}, "auto");
        object.cull = cull == "back" ? Cull::Back : cull == "none" ? Cull::None : Cull::Auto;
        if (table.has("mesh") == table.has("shape"))
            table.fail({}, table.has("mesh") ? "has both mesh and shape" : "has neither mesh nor shape",
                       "mesh or shape");
        object.mesh = table.has("mesh") ? readObj(readPath(table, "mesh")) : readShape(table.table("shape"));
        if (object.scheme == Scheme::None && !object.mesh.normalsMissing.empty())
            table.fail("mesh", "normals of " + object.mesh.name + ": " + object.mesh.normalsMissing,
                       "normals on every face or on none under scheme \"none\"");
        readCreases(table, object.scheme, object.mesh);
        readMerge(table, object.mesh);
    }

    static void checkSurface(const TomlTable& table, const SceneObject& object) {
        try {
            checkControlMesh(object.meshWorld(), object.scheme);
            if (object.scheme != Scheme::None) checkLimitTopology(object.mesh);
        } catch (const InputError& error) { // names the face; the scene file's line identifies the object
            table.fail(table.has("mesh") ? "mesh" : "shape", error.what());
        }
    }

    static void readPlacement(const TomlTable& table, SceneObject& object) {
        constexpr double kLargestAngle = 1e6; // degrees
        object.translate = table.vector3("translate", -kLargestLength, kLargestLength, Vec3(0));
        object.rotateDegrees = table.vector3("rotate_degrees", -kLargestAngle, kLargestAngle, Vec3(0));
        object.scale = table.number("scale", kSmallestLength, kLargestLength, 1.0);
    }

    /// `key` names the field that needs uvs.
    static void requireUvs(const TomlTable& table, const char* key, const ControlMesh& mesh) {
        if (mesh.hasUvs()) return;
        table.fail(
            key,
            fmt::format("{} has no uvs{}{}", mesh.name, mesh.uvsMissing.empty() ? "" : ": ", mesh.uvsMissing),
            "a mesh with a uv index at every corner");
    }

    void readRelief(const TomlTable& objectTable, SceneObject& object) {
        const TomlTable table = objectTable.table("relief");
        requireUvs(objectTable, "relief", object.mesh);
        Relief relief;
        if (table.has("map") == table.has("constant"))
            table.fail({}, table.has("map") ? "has both map and constant" : "has neither map nor constant",
                       "map (a height map's name) or constant (a depth in [0,1])");
        relief.map = table.has("map") ? findMap(table)
                                      : std::make_shared<const HeightMap>(HeightMap::constant(
                                            "constant", static_cast<float>(table.number("constant", 0, 1))));
        relief.depth = table.number("depth", 0, kLargestLength);
        relief.offset = table.number("offset", -kLargestLength, kLargestLength, 0.0);
        relief.tile = table.vector2("tile", -kLargestTile, kLargestTile, Vec2(1));
        if (std::abs(relief.tile.x) < kSmallestTile || std::abs(relief.tile.y) < kSmallestTile)
            table.fail("tile", fmt::format("is [{}, {}]", relief.tile.x, relief.tile.y), "neither of them 0");
        relief.uvOffset = table.vector2("uv_offset", -kLargestTile, kLargestTile, Vec2(0));
        relief.seams = table.choice("seams", {"weld", "open"}, "weld") == "open" ? Seams::Open : Seams::Weld;
        if (table.choice("along", {"normal", "axis"}, "normal") == "axis")
            relief.axisWorld = object.axisWorld();
        table.finish();
        object.relief = relief;
    }

    std::shared_ptr<const HeightMap> findMap(const TomlTable& relief) const {
        const std::string name = relief.text("map");
        const auto found = maps_.find(name);
        if (found != maps_.end()) return found->second;
        const std::vector<std::string> names(mapNames_.begin(), mapNames_.end());
        relief.fail("map", fmt::format("no height map is called \"{}\"", name),
                    names.empty() ? "a [[height_map]] of that name" : listOf(names), didYouMean(name, names));
    }

    void readColor(const TomlTable& table, SceneObject& object) {
        if (!table.has("color_map")) {
            object.color = table.vector3("color", 0, 1, object.color);
            return;
        }
        if (table.has("color")) table.fail("color_map", "is given together with color", "one of the two");
        requireUvs(table, "color_map", object.mesh);
        const std::filesystem::path path = readPath(table, "color_map");
        std::shared_ptr<const ColorMap>& map = colorMaps_[path.string()];
        if (!map) map = std::make_shared<const ColorMap>(readColorMap(path));
        object.colorMap = map;
    }

    /// [require]: "METRIC" = "OPERATOR NUMBER", or an array of such bounds.
    void readRequirements() {
        if (!root_.has(kRequire)) return;
        const TomlTable table = root_.table(kRequire);
        for (const std::string& metric : table.keys()) {
            const std::vector<std::string> bounds = table.textOrTexts(metric);
            if (bounds.empty()) table.fail(metric, "has no bound", "one or more, for example \">= 0.99\"");
            for (const std::string& bound : bounds)
                scene_.requirements.push_back({fmt::format("{} {}", metric, bound), table.where(metric)});
        }
    }

    std::filesystem::path file_;
    TomlTable root_;
    Scene scene_;
    ContentHash hash_;
    std::set<std::string> mapNames_;
    std::map<std::string, std::shared_ptr<const HeightMap>> maps_;
    std::map<std::string, std::shared_ptr<const ColorMap>> colorMaps_;
};

} // namespace

Scene readScene(const std::filesystem::path& file, const SceneChanges& changes) {
    SceneReader reader(file);
    for (const std::string& change : changes)
        reader.change(change);
    return reader.read();
}

Scene parseScene(const std::filesystem::path& file, const std::string& text) {
    return SceneReader(file, text).read();
}

std::shared_ptr<const HeightMap> readSceneMap(const std::filesystem::path& file, const std::string& name) {
    SceneReader reader(file);
    reader.read(); // all of it: a scene with any error is rejected
    return reader.mapNamed(name);
}

} // namespace plumbline
