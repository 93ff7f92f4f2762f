#include "validate/cli/trial.h"

#include "realtime/technique/technique_list.h"
#include "scenes/core/error.h"
#include "validate/compare/frame_metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

std::vector<std::string> limitsOf(const TechniqueRequest& request) {
    try {
        return readTechniqueManifest(techniqueFolder(request.search)).limits;
    } catch (const InputError&) {
        return {};
    }
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

Trial tryTechnique(const TechniqueRequest& request, const std::map<std::string, std::string>& settings,
                   TechniqueDrawer& drawer, const std::vector<MicroMesh>* microMeshes) {
    Trial trial;
    trial.outcome.name = displayName(request, settings);
    trial.outcome.control = drawsMicroTriangles(request);
    trial.outcome.limits = limitsOf(request);
    try {
        TechniqueResult result =
            drawer.draw(request, settings, trial.outcome.control ? microMeshes : nullptr);
        trial.outcome.parameters = result.parameters;
        trial.outcome.backend = result.backend;
        trial.outcome.renderer = result.renderer;
        trial.outcome.cost.msMedian = result.msMedian;
        trial.outcome.msRuns = result.msRuns;
        trial.outcome.timer = result.timer;
        trial.warnings = result.warnings;
        trial.outcome.cost.bakeMs = result.bakeMs;
        trial.outcome.cost.bakeBytes = static_cast<double>(result.bakeBytes);
        trial.frame = std::move(result.frame);
    } catch (const InputError& error) {
        trial.outcome.error = error.what();
        trial.exitCode = kExitBadInput;
    } catch (const MachineError& error) {
        trial.outcome.error = error.what();
        trial.exitCode = kExitMachine;
    }
    return trial;
}

void compareTrial(Trial& trial, const Frame& reference, const Scene& scene) {
    trial.outcome.comparison = compareFrames(reference, trial.frame, objectsOf(scene), scene.camera);
    if (const size_t broken = brokenPixels(trial.frame); broken > 0)
        trial.warnings.push_back(
            fmt::format("{}: {} covered pixels have a position, depth, normal or st that is no number; "
                        "no figure counts them",
                        trial.outcome.name, broken));
    trial.outcome.comparison.notes.insert(trial.outcome.comparison.notes.end(), trial.warnings.begin(),
                                          trial.warnings.end());
}

} // namespace plumbline
