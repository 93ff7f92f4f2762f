#include "realtime/technique/technique_list.h"

#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

/// Subfolders of `folder`, sorted, without those that begin with '_' or '.'.
std::vector<std::string> folderNames(const fs::path& folder) {
    std::error_code error;
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory() && name[0] != '_' && name[0] != '.') names.push_back(name);
    }
    if (error) throw MachineError(folder.string(), "can't be listed: " + error.message());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

fs::path techniquesFolder() {
    return dataFolder() / "realtime" / "techniques";
}

fs::path surfacesFolder() {
    return dataFolder() / "realtime" / "surfaces";
}

std::vector<std::string> techniqueNames() {
    return folderNames(techniquesFolder());
}

std::vector<std::string> surfaceNames() {
    return folderNames(surfacesFolder());
}

fs::path techniqueFolder(const std::string& search) {
    const std::vector<std::string> names = techniqueNames();
    if (std::find(names.begin(), names.end(), search) != names.end()) return techniquesFolder() / search;
    if (fs::is_directory(search)) return search;
    const bool isPath = search.find('/') != std::string::npos;
    throw NoSuchTechnique("technique", fmt::format("'{}' is {}", search, isPath ? "no folder" : "not known"),
                          isPath ? "a folder with technique.toml" : listOf(names) + ", or a folder",
                          didYouMean(search, names));
}

std::vector<Manifest> listTechniques() {
    std::vector<Manifest> manifests;
    for (const std::string& name : techniqueNames())
        manifests.push_back(readTechniqueManifest(techniquesFolder() / name));
    return manifests;
}

std::vector<Manifest> listSurfaces() {
    std::vector<Manifest> manifests;
    for (const std::string& name : surfaceNames())
        manifests.push_back(readSurfaceManifest(surfacesFolder() / name));
    return manifests;
}

} // namespace plumbline
