#include "scenes/draft/scene_text.h"

#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/toml/toml_tree.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace plumbline {
namespace {

constexpr size_t kCommentWidth = 100;

std::string fileText(const std::filesystem::path& file) {
    if (const auto text = tomlText(file.generic_string())) return *text;
    throw InputError(file.generic_string(), "the name isn't UTF-8, as all of a scene file must be",
                     "another name");
}

/// The shortest text of a value that only needs to be accurate to `step`.
std::string numberText(double value, double step) {
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step))));
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string vectorText(const Vec3& vector, double step) {
    return fmt::format("[{}, {}, {}]", numberText(vector.x, step), numberText(vector.y, step),
                       numberText(vector.z, step));
}

/// The text as comment lines that begin with "# ", broken at spaces; empty for an empty text.
std::string comment(const std::string& text) {
    std::istringstream words(printable(text));
    std::string result, line, word;
    while (words >> word) {
        if (!line.empty() && line.size() + word.size() >= kCommentWidth) {
            result += "# " + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return line.empty() ? result : result + "# " + line + "\n";
}

/// A valid scene-file name derived from a file name.
std::string nameFrom(const std::filesystem::path& file, const char* otherwise) {
    constexpr size_t kLongest = 64;
    std::string name = file.stem().string().substr(0, kLongest);
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
    return name.empty() ? otherwise : name;
}

const char* schemeText(Scheme scheme) {
    return scheme == Scheme::Loop ? "loop" : scheme == Scheme::None ? "none" : "catmull-clark";
}

const char* wrapText(Wrap wrap) {
    return wrap == Wrap::Clamp ? "clamp" : "repeat";
}

} // namespace

std::string sceneText(const SceneDraft& draft, const std::filesystem::path& meshFile,
                      const std::filesystem::path& mapFile, const HeightMap& map, bool storesHeight) {
    constexpr double kDirectionStep = 1e-3; // a twentieth of a degree
    const std::string meshText = fileText(meshFile), mapText = fileText(mapFile);
    const std::string meshName = nameFrom(meshFile, "mesh"), mapName = nameFrom(mapFile, "map");
    const SceneDraft::Reasons& why = draft.reasons;
    const Camera& camera = draft.camera;
    std::string text = fmt::format("purpose = \"{} under {}\"\n", meshName, mapName);
    text += comment("A first draft: every value may be changed, and scenes/README.md describes every field. "
                    "Lengths are in "
                    "world units, those of the mesh.");
    text += "background = [0.02, 0.02, 0.03]\n\n[camera]\n" + comment(why.camera);
    text += fmt::format(
        "position = {}\ntarget = {}\nfov_y_degrees = {}\nwidth = {}\nheight = {}\n\n[[light]]\n",
        vectorText(camera.positionWorld, draft.lengthStep), vectorText(camera.targetWorld, draft.lengthStep),
        camera.fovYDegrees, camera.width, camera.height);
    text += comment(why.light);
    text += fmt::format("name = \"sun\"\nto_light = {}\n\n[[height_map]]\nname = \"{}\"\nfile = {}\n",
                        vectorText(draft.toLight, kDirectionStep), mapName, mapText);
    text += comment("\"height\": bright is high; \"depth\": bright is deep. The other one, if the relief "
                    "looks inside out.");
    text += fmt::format("stores = \"{}\"\nwrap = [\"{}\", \"{}\"]\n\n[[object]]\nname = \"{}\"\nmesh = {}\n",
                        storesHeight ? "height" : "depth", wrapText(map.wrapS()), wrapText(map.wrapT()),
                        meshName, meshText);
    text += comment(why.scheme) + fmt::format("scheme = \"{}\"\n", schemeText(draft.scheme));
    if (draft.merge) text += comment(why.merge) + "merge = true\n";
    text += comment(why.proxyRate) + fmt::format("proxy_rate = {}\n", draft.proxyRate);
    if (draft.translate != Vec3(0))
        text += comment(why.translate) +
                fmt::format("translate = {}\n", vectorText(draft.translate, draft.lengthStep));
    text += comment(why.depth) + comment(why.tile) +
            comment("offset: 0 carves the relief into the mesh, depth raises it onto the mesh.");
    text += fmt::format("relief = {{ map = \"{}\", depth = {}, offset = 0, tile = [{}, {}] }}\n", mapName,
                        draft.depth, draft.tile.x, draft.tile.y);
    return text + "color = [0.8, 0.75, 0.7]\n";
}

} // namespace plumbline
