// One case of a study, computed in a separate process (case_pool.h is its parent's side).
#pragma once

#include "realtime/gl/gl_options.h"
#include "validate/study/study_cases.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>

namespace plumbline {

/// Options of the process, in addition to the case.
struct CaseOptions {
    uint64_t referenceBytes = 0; // budget of the reference
    double referenceErrorPx = 0; // its aim
    uint64_t drawBytes = 0;      // limit of the drawing process
    GlOptions gl;                // but for the time spent on timing, which is the grid's
    int threads = 1;
    int timeLimitSeconds = 60; // a technique
};

/// The request for it.
nlohmann::json caseRequest(const StudyCase& studyCase, const CaseOptions& options);

/// Does what a request says: {"reference", "fit", "techniques": [{"name", "result"}], "pairs": [{"first",
/// "second", "result"}]}. Throws InputError or MachineError for what makes the whole case impossible.
nlohmann::json runCase(const nlohmann::json& request);

/// Fingerprint of what decides what the techniques of a grid draw: manifests, shaders, settings. Throws
/// InputError for a technique there isn't.
std::string techniquesHash(const StudyGrid& grid);

} // namespace plumbline
