// Draws a technique and compares it with the reference, for validate and study.
#pragma once

#include "validate/cli/exit_codes.h"
#include "validate/cli/technique_drawer.h"
#include "validate/results/results.h"

namespace plumbline {

/// The frame and figures of a technique.
struct Trial {
    TechniqueOutcome outcome;
    Frame frame;
    std::vector<std::string> warnings;
    int exitCode = kExitDone;
};

/// Draws it. What keeps it from being resolved or drawn becomes the outcome's error. `microMeshes`: of the
/// reference, for the control technique; may be null if that isn't asked for.
Trial tryTechnique(const ChosenTechnique& chosen, TechniqueDrawer& drawer,
                   const std::vector<MicroMesh>* microMeshes);

/// Compares a frame that was drawn with the reference, and warns of faulty hits and of back sides that are
/// missing.
void compareTrial(Trial& trial, const Frame& reference, const Scene& scene);

} // namespace plumbline
