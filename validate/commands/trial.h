// What validate and study do for each frame: the reference drawn, a technique drawn and held against it.
#pragma once

#ifdef PLUMBLINE_GL
#include "../../reference/reference.h"
#include "shared.h"
#include "technique_drawer.h"

namespace plumbline {

/// Draws the reference and says so; frees what drew it unless `kept` takes it.
Frame drawReference(const Scene& scene, const ReferenceOptions& options, Progress& progress,
                    ReferenceSummary& summary, std::unique_ptr<ReferenceScene>* kept);

/// One technique's frame and figures.
struct Trial {
    TechniqueOutcome outcome;
    Frame frame;
    std::vector<std::string> warnings;
    int exitCode = kExitDone;
};

/// Draws it. What InputError or MachineError says becomes the outcome's error. `microMeshes`: of the reference, for the control
/// technique; may be null if that isn't asked for.
Trial tryTechnique(const TechniqueRequest& request, const std::map<std::string, std::string>& settings,
                   TechniqueDrawer& drawer, const std::vector<MicroMesh>* microMeshes);

/// Holds a frame that was drawn against the reference, and warns of pixels that hold no numbers.
void compareTrial(Trial& trial, const Frame& reference, const Scene& scene);

} // namespace plumbline
#endif
