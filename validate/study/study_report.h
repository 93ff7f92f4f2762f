// What is shown of a study: FOLDER/report/index.html, offline, and FOLDER/report/tables.md with the same
// tables as Markdown, to go into a text.
#pragma once

#include "validate/study/study_results.h"

namespace plumbline {

/// Throws InputError for a figure that no row has, MachineError without gnuplot. `missing`: cases without
/// results.
void writeStudyReport(const Study& study, const std::vector<StudyRow>& rows, size_t cases, size_t missing,
                      const std::filesystem::path& folder);

} // namespace plumbline
