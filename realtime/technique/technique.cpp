#include "realtime/technique/technique.h"

#include "realtime/bake/bake.h"
#include "realtime/technique/baked_family.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/harness_parameters.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/contains.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

std::vector<std::string> namesOf(const std::vector<Parameter>& parameters) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters)
        names.push_back(parameter.name);
    std::sort(names.begin(), names.end());
    return names;
}

/// Sets values; `own` takes precedence over `shared`, which takes precedence over the current values.
void setValues(std::vector<Technique::Setting>& settings, const std::string& where, const Settings& own,
               const Settings& shared) {
    for (auto& [parameter, value] : settings) {
        if (const auto found = own.find(parameter.name); found != own.end())
            value = parameter.parse(where, found->second);
        else if (const auto foundShared = shared.find(parameter.name); foundShared != shared.end())
            value = parameter.parse(where, foundShared->second);
    }
}

std::vector<Technique::Setting> withDefaults(const std::vector<Parameter>& parameters) {
    std::vector<Technique::Setting> settings;
    for (const Parameter& parameter : parameters)
        settings.push_back({parameter, parameter.defaultValue});
    return settings;
}

/// The parameters of search and surface, which share the shader's namespace.
std::vector<Parameter> shaderParameters(const Manifest& search, const Manifest& surface) {
    std::vector<Parameter> parameters = search.parameters;
    for (const Parameter& parameter : surface.parameters) {
        if (contains(namesOf(search.parameters), parameter.name))
            throw InputError(
                search.file.string(),
                fmt::format("parameter '{}' is also one of surface '{}'", parameter.name, surface.name),
                "another name");
        parameters.push_back(parameter);
    }
    return parameters;
}

/// A shader has only one sampler per family.
void checkFamilies(const Technique& technique) {
    std::map<std::string, std::string> kinds;
    for (const std::string& kind : technique.bakedKinds())
        if (const auto [first, isNew] = kinds.emplace(bakedFamily(kind).sampler, kind); !isNew)
            throw InputError(
                technique.search.file.string(),
                fmt::format("takes both '{}' and '{}', which belong to the same family", first->second, kind),
                "one of them");
}

[[noreturn]] void refuseSurface(const TechniqueRequest& request, const std::vector<std::string>& choices,
                                const std::string& reason = {}) {
    throw NoSuchTechnique("--technique",
                          fmt::format("'{}' has no surface '{}'{}{}", request.search, request.surface,
                                      reason.empty() ? "" : ": ", reason),
                          listOf(choices), didYouMean(request.surface, choices));
}

const Manifest& surfaceFor(const TechniqueRequest& request, const Manifest& search,
                           ManifestCache& manifests) {
    if (!contains(surfaceNames(), request.surface))
        refuseSurface(request, surfacesFor(search, listSurfaces()));
    const Manifest& surface = manifests.surface(request.surface);
    if (const std::string refusal = refusalOf(search, surface); !refusal.empty())
        refuseSurface(request, surfacesFor(search, listSurfaces()), refusal);
    return surface;
}

} // namespace

std::string Technique::name() const {
    std::string text = search.name;
    if (surface && surface->name != kFlatSurface) text += "@" + surface->name;
    std::map<std::string, std::string> changed;
    for (const auto* settings : {&shaderSettings, &harnessSettings})
        for (const auto& [parameter, value] : *settings)
            if (!(value == parameter.defaultValue)) changed[parameter.name] = parameter.format(value);
    char separator = ':';
    for (const auto& [key, value] : changed) {
        text += fmt::format("{}{}={}", separator, key, value);
        separator = ',';
    }
    return text;
}

TechniqueRequest Technique::request() const {
    return {search.folder.string(), surface ? surface->name : kFlatSurface, parameters()};
}

std::vector<std::string> Technique::settingNames() const {
    std::vector<std::string> names;
    for (const auto* settings : {&shaderSettings, &harnessSettings})
        for (const Setting& setting : *settings)
            names.push_back(setting.parameter.name);
    std::sort(names.begin(), names.end());
    return names;
}

void Technique::set(const Settings& own, const Settings& shared) {
    const std::string where = name();
    const std::vector<std::string> known = settingNames();
    for (const auto& [key, value] : own)
        if (!contains(known, key))
            throw InputError(where, fmt::format("has no parameter '{}'", key),
                             known.empty() ? "none, it takes no parameters" : listOf(known),
                             didYouMean(key, known));
    setValues(shaderSettings, where, own, shared);
    setValues(harnessSettings, where, own, shared);
    checkFamilies(*this);
}

std::vector<std::string> Technique::bakedKinds() const {
    std::vector<std::string> kinds;
    for (const std::string& input : search.inputs) {
        if (isBakeKind(input)) kinds.push_back(input);
        for (const auto& [parameter, value] : shaderSettings)
            if (parameter.name == input) kinds.push_back(parameter.format(value));
    }
    return kinds;
}

CurvatureSet Technique::curvatureSet() const {
    const bool full = surface->hasInput("quadric_full");
    if (choice("coefficients") == "limit")
        return full ? CurvatureSet::LimitThreeTerms : CurvatureSet::LimitTwoTerms;
    return full ? CurvatureSet::RingThreeTerms : CurvatureSet::RingTwoTerms;
}

const Technique::Setting* Technique::harness(const std::string& settingName) const {
    for (const Setting& setting : harnessSettings)
        if (setting.parameter.name == settingName) return &setting;
    return nullptr;
}

std::string Technique::choice(const std::string& settingName) const {
    const Setting* setting = harness(settingName);
    return setting ? setting->parameter.format(setting->value) : std::string();
}

Settings Technique::parameters() const {
    Settings texts;
    for (const auto* settings : {&shaderSettings, &harnessSettings})
        for (const Setting& setting : *settings)
            texts[setting.parameter.name] = setting.parameter.format(setting.value);
    return texts;
}

std::string Technique::glslConstants() const {
    std::string text;
    for (const auto& [parameter, value] : shaderSettings) {
        switch (parameter.type) {
        case ParameterValue::Type::Bool:
            text += fmt::format("const bool {} = {};\n", parameter.name, parameter.format(value));
            break;
        case ParameterValue::Type::Float:
            text += fmt::format("const float {} = {:.9e};\n", parameter.name, value.number);
            break;
        case ParameterValue::Type::Int:
            text += fmt::format("const int {} = {};\n", parameter.name, parameter.format(value));
            break;
        case ParameterValue::Type::Choice:
            text += fmt::format("const int {} = {};\n", parameter.name, static_cast<int>(value.number));
            for (size_t i = 0; i < parameter.choices.size(); ++i)
                text += fmt::format("const int {}_{} = {};\n", parameter.name, parameter.choices[i], i);
            break;
        }
    }
    return text;
}

Technique composeTechnique(const TechniqueRequest& request, ManifestCache& manifests) {
    Technique technique;
    technique.search = manifests.search(request.search);
    if (technique.drawsMicroTriangles()) {
        if (request.surface != kFlatSurface) refuseSurface(request, {kFlatSurface});
        return technique;
    }
    technique.surface = surfaceFor(request, technique.search, manifests);
    technique.shaderSettings = withDefaults(shaderParameters(technique.search, *technique.surface));
    technique.harnessSettings = withDefaults(harnessParameters(technique.search, *technique.surface));
    return technique;
}

Technique resolveTechnique(const TechniqueRequest& request, const Settings& shared) {
    ManifestCache manifests;
    Technique technique = composeTechnique(request, manifests);
    technique.set(request.settings, shared);
    return technique;
}

Technique resolveTechnique(const std::string& text, const Settings& shared) {
    return resolveTechnique(parseTechnique(text), shared);
}

} // namespace plumbline
