#include "validate/cli/requirements.h"

#include "validate/results/results.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>

namespace plumbline {

void RequirementArguments::addTo(CLI::App& command) {
    command
        .add_option("--require", require,
                    "A requirement, for example \"silhouette.iou >= 0.99\"; exit code 1 if not reached; may "
                    "be repeated")
        ->type_name("METRIC>=X")
        ->allow_extra_args(false);
}

std::vector<Requirement> readRequirements(const std::vector<std::string>& texts,
                                          const std::vector<SceneRequirement>& ofScene) {
    std::vector<Requirement> requirements;
    for (const std::string& text : texts)
        requirements.push_back(parseRequirement(text, "--require"));
    for (const SceneRequirement& each : ofScene)
        requirements.push_back(parseRequirement(each.text, each.where));
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
        fmt::print(stderr, "{}: {} {}; required {}\n", outcome.name, result.key, found, result.requirement);
    }
    return all;
}

} // namespace plumbline
