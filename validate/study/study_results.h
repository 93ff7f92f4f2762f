// The figures of a study, row by row.
#pragma once

#include "validate/study/study_folder.h"

#include <optional>

namespace plumbline {

/// A technique of a case, held against the reference or, of a pair, against the first technique of it. A
/// failed case has one row with its error and no technique.
struct StudyRow {
    std::string caseId, grid, scene;
    std::map<std::string, std::string> values; // by axis
    std::string technique, against;            // labels; against: "reference" where it isn't a pair
    std::map<std::string, double> figures;     // "depth.rmse_relief"; absent ones are left out
    std::string error;                         // of the case or the technique
};

/// The rows of one case. `outcome`: StudyFolder::outcomeOf.
std::vector<StudyRow> rowsOf(const StudyCase& studyCase, const nlohmann::json& outcome);

/// A failed row's error, with the technique it is about.
std::string errorOf(const StudyRow& row);

/// RFC 4180, a head line first: case, grid, scene, the axes, technique, against, the figures, error.
std::string studyCsv(const std::vector<StudyRow>& rows);

/// What tells rows apart: an axis, "scene" or "technique".
std::string groupOf(const StudyRow& row, const std::string& grouping);

/// Throws InputError for a figure that no row of the grid has.
void checkFigure(const std::vector<StudyRow>& rows, const StudyRows& choice);

/// A table's or plot's numbers by two groupings: of the rows chosen, the statistic of those that fall
/// together. Groups without a figure are left out. Throws as checkFigure.
struct StudyCells {
    std::map<std::pair<std::string, std::string>, double> values;
};
StudyCells cellsOf(const std::vector<StudyRow>& rows, const StudyRows& choice, const std::string& first,
                   const std::string& second);

/// Whether a row is among those chosen, failed ones never.
bool isChosen(const StudyRow& row, const StudyRows& choice);

} // namespace plumbline
