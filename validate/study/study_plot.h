// Plots of a study, as SVG, by gnuplot (Debian's gnuplot-nox).
#pragma once

#include "validate/study/study_results.h"

namespace plumbline {

/// Throws MachineError if gnuplot isn't there.
void requireGnuplot();

/// Draws one plot to `file`. Throws InputError for a figure that no row has, MachineError if gnuplot fails.
/// False: no row is chosen, nothing was drawn.
bool drawPlot(const Study& study, const StudyPlot& plot, const std::vector<StudyRow>& rows,
              const std::filesystem::path& file);

/// What it reads; empty where no row is chosen. The picture is what it prints.
std::string gnuplotScript(const Study& study, const StudyPlot& plot, const std::vector<StudyRow>& rows);

} // namespace plumbline
