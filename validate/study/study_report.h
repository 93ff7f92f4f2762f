// The report of a study: FOLDER/report/index.html, which can be opened offline, and FOLDER/report/tables.md
// with the same tables as Markdown, to be copied into a document.
#pragma once

#include "validate/study/study_results.h"

namespace plumbline {

/// `missing`: number of cases without results. Throws InputError for a figure that no row has, MachineError
/// without gnuplot.
void writeStudyReport(const Study& study, const std::vector<StudyRow>& rows, size_t cases, size_t missing,
                      const std::filesystem::path& folder);

} // namespace plumbline
