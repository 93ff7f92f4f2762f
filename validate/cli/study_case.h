// One case of a study, computed in a separate process (case_pool.h is its parent's side).
#pragma once

#include "validate/study/study_cases.h"

#include <nlohmann/json_fwd.hpp>

namespace plumbline {

/// Options of the process, in addition to the case.
struct CaseOptions {
    std::string memory, errorPx; // of the reference; errorPx empty: its own default
    std::string glBackend = "auto";
    int glDevice = -1;
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
