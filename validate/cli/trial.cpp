#include "validate/cli/trial.h"

#include "scenes/core/error.h"
#include "scenes/frame/object_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// Covered pixels with a value that isn't finite: a technique could hide its errors there.
size_t brokenPixels(const Frame& frame) {
    const bool hasCoverage = frame.has("A");
    const auto covered = frame.channel(hasCoverage ? "A" : "id");
    std::vector<bool> broken(frame.pixelCount(), false);
    for (const char* name : {"Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S", "st.T"}) {
        if (!frame.has(name)) continue;
        const auto plane = frame.channel(name);
        for (size_t i = 0; i < plane.size(); ++i)
            if (covered[i] > 0 && !std::isfinite(plane[i])) broken[i] = true;
    }
    return static_cast<size_t>(std::count(broken.begin(), broken.end(), true));
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
    if (const size_t broken = brokenPixels(trial.frame); broken > 0)
        trial.warnings.push_back(
            fmt::format("{}: {} covered pixels have a position, depth, normal or st that isn't a number; "
                        "figures leave them out",
                        trial.outcome.name, broken));
    trial.outcome.comparison.notes.insert(trial.outcome.comparison.notes.end(), trial.warnings.begin(),
                                          trial.warnings.end());
}

} // namespace plumbline
