// The part of shared.h that needs realtime/.
#include "realtime/technique/composition.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/error.h"
#include "validate/cli/shared.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace plumbline {
namespace {

// The one search that variants of a surface are drawn with in `all`: one row tells of a surface, twelve only
// lengthen the table.
constexpr const char* kSearchForVariants = "linear_binary";

/// Every search on every surface it composes with that is no variant of another one; variants with one
/// search.
std::vector<TechniqueRequest> allTechniques() {
    std::set<std::string> variants;
    const std::vector<Manifest> library = listSurfaces();
    for (const Manifest& surface : library)
        if (!surface.variantOf.empty()) variants.insert(surface.name);
    std::vector<TechniqueRequest> requests;
    for (const Manifest& info : listTechniques()) {
        TechniqueRequest request;
        request.search = info.name;
        if (info.drawsMicroTriangles()) requests.push_back(request);
        for (const std::string& surface : surfacesFor(info, library)) {
            if (variants.contains(surface) && info.name != kSearchForVariants) continue;
            request.surface = surface;
            requests.push_back(request);
        }
    }
    // The control goes first: where it fails, no other result means anything.
    std::stable_partition(requests.begin(), requests.end(), drawsMicroTriangles);
    return requests;
}

/// Throws for a surface the technique doesn't compose with; says nothing where its manifest can't be read.
void requireSurface(const TechniqueRequest& request) {
    std::vector<std::string> surfaces;
    std::string reason;
    try {
        const Manifest info = readTechniqueManifest(techniqueFolder(request.search));
        const std::vector<Manifest> library = listSurfaces();
        surfaces = surfacesFor(info, library);
        for (const Manifest& surface : library)
            if (surface.name == request.surface) reason = refusalOf(info, surface);
    } catch (const InputError&) {
        return;
    }
    if (surfaces.empty()) surfaces = {"flat"}; // what a request without '@' says
    if (std::find(surfaces.begin(), surfaces.end(), request.surface) != surfaces.end()) return;
    throw InputError("--technique",
                     fmt::format("'{}' has no surface '{}'{}", request.search, request.surface,
                                 reason.empty() ? "" : ": " + reason),
                     listOf(surfaces), didYouMean(request.surface, surfaces));
}

/// A typing error must not cost a whole run: names that aren't there are refused at once, faults inside a
/// technique's folder are reported beside the results of the others.
void requireExists(const TechniqueRequest& request) {
    std::vector<std::string> names;
    for (const Manifest& info : listTechniques())
        names.push_back(info.name);
    std::error_code ignored;
    if (std::find(names.begin(), names.end(), request.search) == names.end() &&
        !std::filesystem::is_directory(request.search, ignored)) {
        (void)readTechniqueManifest(techniqueFolder(
            request.search)); // says more where there is a folder of that name with a broken manifest
        throw InputError("--technique", fmt::format("there is no technique '{}'", request.search),
                         listOf(names) + ", or a folder", didYouMean(request.search, names));
    }
    requireSurface(request);
}

void refuseDuplicates(const std::vector<TechniqueRequest>& requests,
                      const std::map<std::string, std::string>& settings) {
    std::set<std::string> names;
    for (const TechniqueRequest& request : requests)
        if (const std::string name = displayName(request, settings); !names.insert(name).second)
            throw InputError("--technique", fmt::format("'{}' is named twice", name), "each technique once",
                             "a folder of the same name as another technique needs another one");
}

} // namespace

std::vector<TechniqueRequest> chosenTechniques(const std::vector<std::string>& texts,
                                               const std::map<std::string, std::string>& settings) {
    const bool all = texts.empty() || std::find(texts.begin(), texts.end(), "all") != texts.end();
    std::vector<TechniqueRequest> requests = all ? allTechniques() : std::vector<TechniqueRequest>{};
    for (const std::string& text : texts) {
        if (text == "all") continue;
        requests.push_back(parseTechnique(text));
        requireExists(requests.back());
    }
    refuseDuplicates(requests, settings);
    return requests;
}

void checkSettings(const std::map<std::string, std::string>& settings,
                   const std::vector<TechniqueRequest>& requests) {
    if (settings.empty()) return;
    std::set<std::string> known;
    for (const TechniqueRequest& request : requests) {
        try {
            for (const std::string& name : knownSettings(request))
                known.insert(name);
        } catch (const InputError&) {
            return; // its manifest can't be read, so nobody knows what it takes; drawing it will say so
        }
    }
    const std::vector<std::string> names(known.begin(), known.end());
    for (const auto& [key, value] : settings)
        if (!known.contains(key))
            throw InputError("--set", fmt::format("no technique of this run takes '{}'", key), listOf(names),
                             didYouMean(key, names));
}

bool drawsMicroTriangles(const TechniqueRequest& request) {
    try {
        return readTechniqueManifest(techniqueFolder(request.search)).drawsMicroTriangles();
    } catch (const InputError&) {
        return false;
    }
}

} // namespace plumbline
