#include "validate/cli/requirements.h"

#include "scenes/core/printable.h"
#include "validate/cli/parsed_option.h"
#include "validate/results/results.h"

#include <fmt/format.h>

#include <cstdio>

namespace plumbline {
namespace {

std::vector<Requirement> parseRequirements(const std::vector<std::string>& texts) {
    std::vector<Requirement> requirements;
    for (const std::string& text : texts)
        requirements.push_back(parseRequirement(text, "--require"));
    return requirements;
}

void checkNames(const std::vector<Requirement>& requirements, const Scene& scene) {
    std::vector<std::string> lights, objects;
    for (const Light& light : scene.lights)
        lights.push_back(light.name);
    for (const SceneObject& object : scene.objects)
        objects.push_back(object.name);
    for (const Requirement& requirement : requirements)
        checkNames(requirement, lights, objects);
}

} // namespace

void RequirementArguments::addTo(CLI::App& command) {
    addParsed<std::vector<std::string>>(
        command, "--require", require, parseRequirements,
        "A requirement, for example \"silhouette.iou >= 0.99\"; exit code 1 if not reached; may be repeated")
        ->type_name("METRIC>=X")
        ->allow_extra_args(false);
}

std::vector<Requirement> requirementsOf(const RequirementArguments& arguments, const Scene& scene) {
    std::vector<Requirement> requirements = arguments.require;
    for (const SceneRequirement& each : scene.requirements)
        requirements.push_back(parseRequirement(each.text, each.where));
    checkNames(requirements, scene);
    return requirements;
}

void checkNames(const std::vector<Requirement>& requirements, const TechniqueOutcome& outcome) {
    const std::set<std::string>& shown = outcome.comparison.pooled.lights();
    const std::vector<std::string> lights(shown.begin(), shown.end());
    std::vector<std::string> objects;
    for (const ObjectComparison& object : outcome.comparison.objects)
        objects.push_back(object.object.name);
    for (const Requirement& requirement : requirements)
        checkNames(requirement, lights, objects);
}

bool holdRequirements(const std::vector<Requirement>& requirements, TechniqueOutcome& outcome) {
    outcome.requirements = evaluateRequirements(requirements, outcome);
    bool all = true;
    for (const RequirementResult& result : outcome.requirements) {
        if (result.passed) continue;
        all = false;
        const std::string found = result.value ? fmt::format("is {}", *result.value)
                                               : fmt::format("is absent ({})", result.value.reason());
        fmt::print(stderr, "{}\n",
                   printable(fmt::format("{}: {} {}; required {}", outcome.name, result.key, found,
                                         result.requirement)));
    }
    return all;
}

} // namespace plumbline
