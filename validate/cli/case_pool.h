// Works out the cases of a study, some at a time, each in a process of its own: one that dies or fails costs
// that case.
#pragma once

#include "validate/cli/study_case.h"

#include <functional>

namespace plumbline {

/// The command by which the program works out a case for itself; --help doesn't list it.
inline constexpr const char* kStudyCaseCommand = "study-case";

/// Called with each case when it is done, one call at a time. `outcome`: as StudyFolder keeps it.
using CaseDone = std::function<void(const StudyCase& studyCase, const nlohmann::json& outcome)>;

/// `jobs` at a time. What `done` throws ends the pool and is thrown on.
void runCases(const std::vector<StudyCase>& cases, int jobs, const CaseOptions& options,
              const CaseDone& done);

/// The other side, what the hidden command does. Returns an exit code.
int serveStudyCase(int parent);

} // namespace plumbline
