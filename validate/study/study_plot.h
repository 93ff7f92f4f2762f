// Plots of a study, as SVG, by gnuplot (Debian's gnuplot-nox).
#pragma once

#include "validate/study/study_results.h"

namespace plumbline {

/// Throws MachineError if gnuplot isn't installed.
void requireGnuplot();

/// Draws one plot to `file`. Returns false, without drawing, if no row is selected. Throws InputError for a
/// figure that no row has, MachineError if gnuplot fails.
bool drawPlot(const Study& study, const StudyPlot& plot, const std::vector<StudyRow>& rows,
              const std::filesystem::path& file);

/// The script for gnuplot, which prints the SVG; empty if no row is selected.
std::string gnuplotScript(const Study& study, const StudyPlot& plot, const std::vector<StudyRow>& rows);

} // namespace plumbline
