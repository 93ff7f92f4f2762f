// Computes the cases of a study in parallel, each in a separate process, so that one that crashes or fails
// doesn't affect the others.
#pragma once

#include "validate/cli/study_case.h"

#include <functional>

namespace plumbline {

/// The command with which the program starts itself for a case; --help doesn't list it.
inline constexpr const char* kStudyCaseCommand = "study-case";

/// Called with each case when it is done, one call at a time. `outcome`: as StudyFolder stores it.
using CaseDone = std::function<void(const StudyCase& studyCase, const nlohmann::json& outcome)>;

/// Computes `jobs` cases in parallel. An exception of `done` ends the pool and is rethrown.
void runCases(const std::vector<StudyCase>& cases, int jobs, const CaseOptions& options,
              const CaseDone& done);

/// The process of a case: runs the internal command. Returns an exit code.
int serveStudyCase(int parent);

} // namespace plumbline
