// --require and [require] in validate and compare.
#pragma once

#include "scenes/scene/scene.h"
#include "validate/results/requirement.h"

namespace CLI {
class App;
}

namespace plumbline {

struct RequirementArguments {
    std::vector<std::string> require; // "silhouette.iou >= 0.99"

    void addTo(CLI::App& command);
};

/// Those of the command line, then those of the scene. Throws InputError (parseRequirement).
std::vector<Requirement> readRequirements(const std::vector<std::string>& texts,
                                          const std::vector<SceneRequirement>& ofScene = {});

/// Throws InputError for a name of a light or an object that the scene hasn't.
void checkNames(const std::vector<Requirement>& requirements, const Scene& scene);

/// The same of frames that were compared.
void checkNames(const std::vector<Requirement>& requirements, const TechniqueOutcome& outcome);

/// Fills in the outcome's requirements and says on stderr, a line each, which it doesn't reach. True if it
/// reaches all.
bool holdRequirements(const std::vector<Requirement>& requirements, TechniqueOutcome& outcome);

} // namespace plumbline
