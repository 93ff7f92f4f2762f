// Techniques and surfaces by name: the library's folders, the text a user types, what `list` shows.
#include "realtime/technique/technique.h"
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

void parseSettings(const std::string& text, const std::string& list, TechniqueRequest& request) {
    size_t begin = 0;
    while (begin <= list.size()) {
        const size_t end = std::min(list.find(',', begin), list.size());
        const std::string item = list.substr(begin, end - begin);
        const size_t equals = item.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == item.size())
            throw InputError("technique '" + text + "'", fmt::format("'{}' is not a setting", item),
                             "key=value");
        if (!request.settings.emplace(item.substr(0, equals), item.substr(equals + 1)).second)
            throw InputError("technique '" + text + "'",
                             fmt::format("sets '{}' twice", item.substr(0, equals)), "each once");
        begin = end + 1;
    }
}

std::vector<TechniqueInfo::Parameter> parametersOf(const Manifest& manifest) {
    std::vector<TechniqueInfo::Parameter> parameters;
    for (const Parameter& parameter : manifest.parameters)
        parameters.push_back({parameter.name, parameter.typeName(), parameter.unit, parameter.meaning,
                              parameter.format(parameter.defaultValue), parameter.rangeText()});
    return parameters;
}

/// The manifest's, and the map, which asks nothing of search or surface.
std::vector<std::string> shadowsOf(const Manifest& manifest) {
    std::vector<std::string> shadows = manifest.shadows;
    if (manifest.geometry == Geometry::Proxy) shadows.emplace_back("map");
    return shadows;
}

TechniqueInfo infoOf(const Manifest& manifest) {
    TechniqueInfo info;
    info.name = manifest.name;
    info.title = manifest.title;
    info.citation = manifest.citation;
    info.folder = manifest.folder.string();
    info.inputs = manifest.inputs;
    info.surfaces = manifest.surfaces;
    info.refusals = manifest.refusals;
    info.shadows = shadowsOf(manifest);
    info.limits = manifest.limits;
    info.drawsMicroTriangles = manifest.geometry == Geometry::MicroTriangles;
    info.parameters = parametersOf(manifest);
    return info;
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

TechniqueRequest parseTechnique(const std::string& text) {
    // '@' and ':' count only behind the last '/', so that folders may have them in their names.
    const size_t slash = text.rfind('/');
    const size_t tail = slash == std::string::npos ? 0 : slash + 1;
    const size_t colon = text.find(':', tail);
    const std::string pieces = text.substr(0, colon);
    const size_t at = pieces.find('@', tail);

    TechniqueRequest request;
    request.search = pieces.substr(0, at);
    while (request.search.size() > 1 && request.search.back() == '/')
        request.search.pop_back();
    if (at != std::string::npos) request.surface = pieces.substr(at + 1);
    if (request.search.empty() || request.surface.empty())
        throw InputError("technique '" + text + "'",
                         request.search.empty() ? "names no search" : "names no surface",
                         "SEARCH[@SURFACE][:key=value,…]");
    if (colon != std::string::npos) parseSettings(text, text.substr(colon + 1), request);
    return request;
}

std::vector<TechniqueInfo> listTechniques() {
    std::vector<TechniqueInfo> infos;
    for (const std::string& name : techniqueNames())
        infos.push_back(infoOf(readTechniqueManifest(techniquesFolder() / name)));
    return infos;
}

std::vector<SurfaceInfo> listSurfaces() {
    std::vector<SurfaceInfo> infos;
    for (const std::string& name : surfaceNames()) {
        const Manifest manifest = readSurfaceManifest(surfacesFolder() / name);
        infos.push_back({manifest.name, manifest.title, manifest.citation, manifest.variantOf,
                         manifest.inputs, shadowsOf(manifest), parametersOf(manifest), manifest.limits});
    }
    return infos;
}

TechniqueInfo techniqueInfo(const TechniqueRequest& request) {
    return infoOf(readTechniqueManifest(techniqueFolder(request.search)));
}

} // namespace plumbline
