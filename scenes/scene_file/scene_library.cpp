#include "scenes/scene_file/scene_library.h"

#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/toml/toml_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

/// The fields before the first table, which include the purpose: in TOML, no field of the root can follow a
/// table.
std::string rootFields(const std::string& text) {
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        if (text[begin] == '[') return text.substr(0, begin);
        begin = end + 1;
    }
    return text;
}

} // namespace

std::vector<LibraryScene> libraryScenes() {
    const std::filesystem::path folder = dataFolder() / "scenes" / "library";
    std::error_code error;
    std::vector<LibraryScene> scenes;
    if (!std::filesystem::is_directory(folder, error)) return scenes;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        const TomlTable root =
            TomlTable::parse(entry.path().string(), rootFields(readWholeFile(entry.path(), kMostTomlBytes)));
        scenes.push_back({entry.path().stem().string(), root.text("purpose"), entry.path()});
    }
    std::ranges::sort(scenes, {}, &LibraryScene::name);
    return scenes;
}

std::filesystem::path findScene(const std::string& nameOrPath) {
    std::error_code error;
    if (std::filesystem::is_regular_file(nameOrPath, error)) return nameOrPath;
    const std::filesystem::path path(nameOrPath);
    if (path.has_parent_path() || path.extension() == ".toml")
        requireInputFile(path, "a scene file, or a name that 'plumbline list scenes' shows");
    std::vector<std::string> names;
    for (const LibraryScene& scene : libraryScenes()) {
        if (scene.name == nameOrPath) return scene.file;
        names.push_back(scene.name);
    }
    throw InputError(
        "scene", fmt::format("neither a file nor a scene of the library is called '{}'", nameOrPath),
        names.empty() ? "a scene file" : "a scene file or " + listOf(names), didYouMean(nameOrPath, names));
}

} // namespace plumbline
