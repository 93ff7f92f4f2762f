#include "realtime/technique/reserved_names.h"

#include "realtime/bake/bake.h"
#include "realtime/glsl/glsl_declarations.h"
#include "realtime/glsl/shader_source.h"
#include "realtime/technique/harness_parameters.h"
#include "realtime/technique/stage_sources.h"
#include "realtime/technique/technique_list.h"

#include <filesystem>
#include <set>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

/// Of the shaders in the folders of all surfaces, so that a parameter fits every one of them.
std::set<std::string> surfaceFileScopeNames() {
    std::set<std::string> names;
    for (const std::string& surface : surfaceNames())
        for (const fs::directory_entry& entry : fs::directory_iterator(surfacesFolder() / surface))
            if (entry.path().extension() == ".glsl") names.merge(fileScopeNames(readShader(entry.path())));
    return names;
}

const std::set<std::string>& reservedNames() {
    static const std::set<std::string> names = [] {
        std::set<std::string> all = harnessNames();
        all.merge(surfaceFileScopeNames());
        for (const std::string& setting : harnessParameterNames())
            all.insert(setting);
        for (const BakeKind& kind : bakeKinds())
            all.emplace(kind.name);
        return all;
    }();
    return names;
}

} // namespace

bool isReserved(const std::string& name) {
    return reservedNames().contains(name);
}

} // namespace plumbline
