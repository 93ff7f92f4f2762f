// Computes the cases of a study in parallel, each in a separate process, so that one that crashes or fails
// doesn't affect the others.
#pragma once

#include "validate/cli/study_case.h"
#include "validate/study/study_folder.h"

#include <nlohmann/json.hpp>

#include <functional>

namespace plumbline {

/// The command with which the program starts itself for a case; --help doesn't list it.
inline constexpr const char* kStudyCaseCommand = "study-case";

struct FinishedCase {
    nlohmann::json outcome; // as StudyFolder stores it
    bool computedHere;      // not by another run in the same folder
};

/// Called with each case when it is done and stored, one call at a time.
using CaseDone = std::function<void(const StudyCase& studyCase, const FinishedCase& finished)>;

/// Computes `jobs` cases in parallel and stores them. Each is claimed first, so that of several runs in one
/// folder one computes it; the others wait for it, and compute it themselves if that run ends before. An
/// exception, also of `done`, ends the pool and is rethrown.
void runCases(const StudyFolder& folder, const std::vector<StudyCase>& cases, int jobs,
              const CaseOptions& options, const CaseDone& done);

/// The process of a case: runs the internal command. Returns an exit code.
int serveStudyCase(int parent);

} // namespace plumbline
