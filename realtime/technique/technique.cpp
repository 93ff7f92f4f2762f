#include "realtime/technique/technique.h"

#include "realtime/bake/bake.h"
#include "realtime/technique/baked_family.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/harness_parameters.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace fs = std::filesystem;

namespace {

constexpr const char* kFlat = "flat";

bool contains(const std::vector<std::string>& list, const std::string& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

std::vector<std::string> namesOf(const std::vector<Parameter>& parameters) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters)
        names.push_back(parameter.name);
    std::sort(names.begin(), names.end());
    return names;
}

/// Own settings over shared ones over defaults.
std::vector<Technique::Setting> chooseValues(const std::vector<Parameter>& parameters,
                                             const std::string& where, const Settings& own,
                                             const Settings& shared) {
    std::vector<Technique::Setting> settings;
    for (const Parameter& parameter : parameters) {
        Technique::Setting setting{parameter, parameter.defaultValue};
        if (const auto found = own.find(parameter.name); found != own.end())
            setting.value = parameter.parse(where, found->second);
        else if (const auto foundShared = shared.find(parameter.name); foundShared != shared.end())
            setting.value = parameter.parse(where, foundShared->second);
        settings.push_back(std::move(setting));
    }
    return settings;
}

std::string resultName(const Technique& technique) {
    Settings changed;
    for (const auto* settings : {&technique.shaderSettings, &technique.harnessSettings})
        for (const Technique::Setting& setting : *settings)
            if (!(setting.value == setting.parameter.defaultValue))
                changed[setting.parameter.name] = setting.parameter.format(setting.value);
    std::string name = technique.search.name;
    if (technique.surface && technique.surface->name != kFlat) name += "@" + technique.surface->name;
    char separator = ':';
    for (const auto& [key, value] : changed) {
        name += fmt::format("{}{}={}", separator, key, value);
        separator = ',';
    }
    return name;
}

/// Everything but the values.
struct Pieces {
    Manifest search;
    std::optional<Manifest> surface;
    std::vector<Parameter> shader, harness;
};

Pieces findPieces(const TechniqueRequest& request) {
    Pieces pieces;
    pieces.search = readTechniqueManifest(techniqueFolder(request.search));
    if (pieces.search.geometry == Geometry::MicroTriangles) {
        if (request.surface != kFlat)
            throw InputError("technique", fmt::format("'{}' composes with no surface", pieces.search.name),
                             "it without @" + request.surface);
        return pieces;
    }
    pieces.surface = readSurfaceManifest(surfaceFolder(request.surface));
    if (const std::string refusal = refusalOf(pieces.search, *pieces.surface); !refusal.empty())
        throw InputError("technique",
                         fmt::format("'{}' doesn't compose with surface '{}': {}", pieces.search.name,
                                     request.surface, refusal),
                         "@" + listOf(surfacesFor(pieces.search, listSurfaces())));
    pieces.shader = pieces.search.parameters;
    for (const Parameter& parameter : pieces.surface->parameters) {
        if (contains(namesOf(pieces.shader), parameter.name))
            throw InputError(
                pieces.search.file.string(),
                fmt::format("parameter '{}' is also one of surface '{}'", parameter.name, request.surface),
                "another name");
        pieces.shader.push_back(parameter);
    }
    pieces.harness = harnessParameters(pieces.search, *pieces.surface);
    return pieces;
}

std::vector<std::string> settingNames(const Pieces& pieces) {
    std::vector<Parameter> all = pieces.shader;
    all.insert(all.end(), pieces.harness.begin(), pieces.harness.end());
    return namesOf(all);
}

/// A shader has one sampler a family.
void checkFamilies(const Technique& technique) {
    std::map<std::string, std::string> kinds;
    for (const std::string& kind : technique.bakedKinds())
        if (const auto [first, isNew] = kinds.emplace(bakedFamily(kind).sampler, kind); !isNew)
            throw InputError(
                technique.search.file.string(),
                fmt::format("takes both '{}' and '{}', which are read in the same way", first->second, kind),
                "one of them");
}

/// "linear_binary@quadric", for messages.
std::string displayName(const Pieces& pieces) {
    const bool flat = !pieces.surface || pieces.surface->name == kFlat;
    return flat ? pieces.search.name : pieces.search.name + "@" + pieces.surface->name;
}

} // namespace

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

Technique resolveTechnique(const TechniqueRequest& request, const Settings& shared) {
    Pieces pieces = findPieces(request);
    const std::string where = displayName(pieces);
    const std::vector<std::string> known = settingNames(pieces);
    for (const auto& [key, value] : request.settings)
        if (!contains(known, key))
            throw InputError(where, fmt::format("has no parameter '{}'", key),
                             known.empty() ? "none, it takes no parameters" : listOf(known),
                             didYouMean(key, known));
    Technique technique;
    technique.shaderSettings = chooseValues(pieces.shader, where, request.settings, shared);
    technique.harnessSettings = chooseValues(pieces.harness, where, request.settings, shared);
    technique.search = std::move(pieces.search);
    technique.surface = std::move(pieces.surface);
    checkFamilies(technique);
    technique.name = resultName(technique);
    return technique;
}

std::vector<std::string> knownSettings(const TechniqueRequest& request) {
    return settingNames(findPieces(request));
}

std::string techniqueName(const TechniqueRequest& request, const Settings& shared) {
    return resolveTechnique(request, shared).name;
}

std::string displayName(const TechniqueRequest& request, const Settings& settings) {
    try {
        return techniqueName(request, settings);
    } catch (const InputError&) {
        return request.surface == "flat" ? request.search : request.search + "@" + request.surface;
    }
}

} // namespace plumbline
