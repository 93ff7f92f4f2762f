// The figures of a study, row by row.
#pragma once

#include "validate/study/study_folder.h"

#include <optional>

namespace plumbline {

/// A technique of a case, compared with the reference or, for a pair, with its first technique. A failed case
/// has one row with its error and no technique.
struct StudyRow {
    std::string caseId, grid, scene;
    std::map<std::string, std::string> values; // by axis
    std::string technique, against;            // labels; against: "reference" if it isn't a pair
    std::map<std::string, double> figures;     // "depth.rmse_relief"; absent ones are left out
    std::string error;                         // of the case or the technique
};

/// The rows of one case. `outcome`: StudyFolder::outcomeOf.
std::vector<StudyRow> rowsOf(const StudyCase& studyCase, const nlohmann::json& outcome);

/// The error of a failed row, with its technique.
std::string errorOf(const StudyRow& row);

/// RFC 4180, with a header line: case, grid, scene, the axes, technique, against, the figures, error.
std::string studyCsv(const std::vector<StudyRow>& rows);

/// The value of a row for a grouping: an axis, "scene" or "technique".
std::string groupOf(const StudyRow& row, const std::string& grouping);

/// Throws InputError for a figure that no row of the grid has.
void checkFigure(const std::vector<StudyRow>& rows, const StudyRows& choice);

/// The numbers of a table or plot by two groupings: the statistic of the selected rows in each group. Groups
/// without a figure are left out. Throws as checkFigure.
struct StudyCells {
    std::map<std::pair<std::string, std::string>, double> values;
};
StudyCells cellsOf(const std::vector<StudyRow>& rows, const StudyRows& choice, const std::string& first,
                   const std::string& second);

/// Whether a row is selected; failed ones never are.
bool isChosen(const StudyRow& row, const StudyRows& choice);

} // namespace plumbline
