// --require and [require] in validate and compare.
#pragma once

#include "scenes/scene/scene.h"
#include "validate/results/requirement.h"

namespace CLI {
class App;
}

namespace plumbline {

struct RequirementArguments {
    std::vector<Requirement> require;

    void addTo(CLI::App& command);
};

/// Those of the command line, then those of the scene. Throws InputError for one of the scene's that is none
/// (parseRequirement), and for a name of a light or an object that the scene hasn't.
std::vector<Requirement> requirementsOf(const RequirementArguments& arguments, const Scene& scene);

/// Throws InputError for a name of a light or an object that two frames, compared, haven't.
void checkNames(const std::vector<Requirement>& requirements, const TechniqueOutcome& outcome);

/// Fills in the outcome's requirements and says on stderr, a line each, which it doesn't reach. True if it
/// reaches all.
bool holdRequirements(const std::vector<Requirement>& requirements, TechniqueOutcome& outcome);

} // namespace plumbline
