#include "validate/cli/trial.h"

#include "scenes/core/error.h"
#include "scenes/frame/object_info.h"
#include "validate/metrics/hit_faults.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

void draw(const Technique& technique, TechniqueDrawer& drawer, const std::vector<MicroMesh>* microMeshes,
          Trial& trial) {
    TechniqueResult result = drawer.draw(technique, microMeshes);
    trial.outcome.parameters = std::move(result.parameters);
    trial.outcome.backend = std::move(result.backend);
    trial.outcome.renderer = std::move(result.renderer);
    trial.outcome.cost.msMedian = result.msMedian;
    trial.outcome.msRuns = result.msRuns;
    trial.outcome.timer = std::move(result.timer);
    trial.outcome.cost.bakeMs = result.bakeMs;
    trial.outcome.cost.bakeBytes = static_cast<double>(result.bakeBytes);
    trial.warnings = std::move(result.warnings);
    trial.frame = std::move(result.frame);
}

void fail(Trial& trial, const std::string& error, int exitCode) {
    trial.outcome.error = error;
    trial.exitCode = exitCode;
}

/// What is to be known of the pixels, beside the figures. What the reference shows is the same for all
/// techniques and is said once.
std::vector<std::string> pixelWarnings(const Trial& trial) {
    std::vector<std::string> warnings;
    for (const std::string& sentence : faultSentences(trial.frame))
        warnings.push_back(fmt::format("{}: {}", trial.outcome.name, sentence));
    for (const auto& [object, metrics] : trial.outcome.comparison.objects)
        if (const Figure& back = metrics.figure("silhouette.back_px"); back && *back > 0)
            warnings.push_back(
                fmt::format("the reference shows the back side of '{}' in {} pixels", object.name, *back));
    return warnings;
}

} // namespace

Trial tryTechnique(const ChosenTechnique& chosen, TechniqueDrawer& drawer,
                   const std::vector<MicroMesh>* microMeshes) {
    Trial trial;
    trial.outcome.name = chosen.name;
    trial.outcome.control = chosen.isControl();
    if (chosen.search) trial.outcome.limits = chosen.search->limits;
    try {
        draw(chosen.resolved(), drawer, microMeshes, trial);
    } catch (const InputError& error) {
        fail(trial, error.what(), kExitBadInput);
    } catch (const MachineError& error) {
        fail(trial, error.what(), kExitMachine);
    }
    return trial;
}

void compareTrial(Trial& trial, const Frame& reference, const Scene& scene) {
    trial.outcome.comparison = compareFrames(reference, trial.frame, objectsOf(scene), scene.camera);
    trial.outcome.comparison.notes.insert(trial.outcome.comparison.notes.end(), trial.warnings.begin(),
                                          trial.warnings.end());
    const std::vector<std::string> warnings = pixelWarnings(trial); // in the notes already
    trial.warnings.insert(trial.warnings.end(), warnings.begin(), warnings.end());
}

} // namespace plumbline
