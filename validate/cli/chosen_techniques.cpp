#include "validate/cli/chosen_techniques.h"

#include "realtime/technique/composition.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/contains.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace plumbline {
namespace {

// The one search that variants of a surface are drawn with in `all`: one row is enough for a surface.
constexpr const char* kSearchForVariants = "linear_binary";

/// Every search on every surface it runs on that is no variant of another one; variants with one search.
std::vector<TechniqueRequest> allTechniques(ManifestCache& manifests) {
    std::vector<Manifest> surfaces;
    std::set<std::string> variants;
    for (const std::string& name : surfaceNames()) {
        surfaces.push_back(manifests.surface(name));
        if (!surfaces.back().variantOf.empty()) variants.insert(name);
    }
    std::vector<TechniqueRequest> controls, others;
    for (const std::string& name : techniqueNames()) {
        const Manifest& search = manifests.search(name);
        if (search.drawsMicroTriangles()) controls.push_back({name, kFlatSurface, {}});
        for (const std::string& surface : surfacesFor(search, surfaces))
            if (!variants.contains(surface) || name == kSearchForVariants)
                others.push_back({name, surface, {}});
    }
    // The control goes first: where it fails, no other result means anything.
    controls.insert(controls.end(), others.begin(), others.end());
    return controls;
}

std::vector<TechniqueRequest> requestsOf(const std::vector<std::string>& texts, ManifestCache& manifests) {
    const bool all = texts.empty() || contains(texts, "all");
    std::vector<TechniqueRequest> requests;
    if (all) requests = allTechniques(manifests);
    for (const std::string& text : texts)
        if (text != "all") requests.push_back(parseTechnique(text));
    return requests;
}

/// Every parameter at its default. A typing error must not cost a whole run: names that aren't there are
/// refused at once.
ChosenTechnique compose(const TechniqueRequest& request, ManifestCache& manifests) {
    ChosenTechnique chosen;
    chosen.name = request.surface == kFlatSurface ? request.search : request.search + "@" + request.surface;
    try {
        chosen.search = manifests.search(request.search);
        chosen.technique = composeTechnique(request, manifests);
    } catch (const NoSuchTechnique&) {
        throw;
    } catch (const InputError& error) {
        chosen.error = error;
    }
    return chosen;
}

void refuseUnknown(const Settings& settings, const std::vector<ChosenTechnique>& techniques) {
    std::set<std::string> known;
    for (const ChosenTechnique& chosen : techniques) {
        if (!chosen.technique) return; // what it takes isn't known
        for (const std::string& name : chosen.technique->settingNames())
            known.insert(name);
    }
    const std::vector<std::string> names(known.begin(), known.end());
    for (const auto& [key, value] : settings)
        if (!known.contains(key))
            throw InputError("--set", fmt::format("no technique of this run takes '{}'", key), listOf(names),
                             didYouMean(key, names));
}

void giveValues(ChosenTechnique& chosen, const Settings& own, const Settings& shared) {
    if (!chosen.technique) return;
    try {
        chosen.technique->set(own, shared);
        chosen.name = chosen.technique->name();
    } catch (const InputError& error) {
        chosen.technique.reset();
        chosen.error = error;
    }
}

void refuseDuplicates(const std::vector<ChosenTechnique>& techniques) {
    std::set<std::string> names;
    for (const ChosenTechnique& chosen : techniques)
        if (!names.insert(chosen.name).second)
            throw InputError("--technique", fmt::format("'{}' is named twice", chosen.name),
                             "each technique once",
                             "a folder of the same name as another technique needs another one");
}

} // namespace

const Technique& ChosenTechnique::resolved() const {
    if (!technique) throw *error;
    return *technique;
}

bool anyControl(const std::vector<ChosenTechnique>& techniques) {
    return std::any_of(techniques.begin(), techniques.end(), std::mem_fn(&ChosenTechnique::isControl));
}

std::vector<ChosenTechnique> chosenTechniques(const std::vector<std::string>& texts,
                                              const Settings& settings) {
    ManifestCache manifests;
    const std::vector<TechniqueRequest> requests = requestsOf(texts, manifests);
    std::vector<ChosenTechnique> techniques;
    for (const TechniqueRequest& request : requests)
        techniques.push_back(compose(request, manifests));
    refuseUnknown(settings, techniques);
    for (size_t i = 0; i < requests.size(); ++i)
        giveValues(techniques[i], requests[i].settings, settings);
    refuseDuplicates(techniques);
    return techniques;
}

} // namespace plumbline
