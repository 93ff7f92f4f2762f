// The results of a study on disk:
//
//     FOLDER/study.json           the name of the study
//     FOLDER/cases/ID.json        one for each case, written atomically when it is done
//     FOLDER/cases/.plumbline-*   claims of cases that are being computed, and files being written
//     FOLDER/results.csv          made of the cases: a row for each case, technique and frame compared with
//     FOLDER/report/              made of the rows
#pragma once

#include "scenes/core/file_lock.h"
#include "validate/study/study_cases.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace plumbline {

class StudyFolder {
  public:
    /// Creates the folder. Throws InputError if it can't be written, or contains the results of another study
    /// or other files.
    StudyFolder(std::filesystem::path folder, const Study& study);
    /// Opens the folder of a study that was run. Throws InputError if there are no results, or those of
    /// another study.
    static StudyFolder open(std::filesystem::path folder, const Study& study);

    const std::filesystem::path& path() const { return folder_; }
    /// JSON: {"scene", "values", "changes", "seconds", "error", "again", "reference", "fit", "techniques":
    /// [{"name", "result"}], "pairs": [{"first", "second", "result"}]}; `error` is null or the reason why
    /// there are no results.
    ///
    /// The stored outcome of a case; nullopt if it wasn't run, was interrupted, or failed for a reason that
    /// may no longer apply (`again`).
    std::optional<nlohmann::json> outcomeOf(const StudyCase& studyCase) const;
    void store(const StudyCase& studyCase, const nlohmann::json& outcome) const;
    /// Keeps other runs, also those of other hosts, from computing the case until it is destroyed or this
    /// process ends. nullopt if another has it.
    std::optional<FileLock> claim(const StudyCase& studyCase) const;

  private:
    explicit StudyFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
    std::filesystem::path fileOf(const StudyCase& studyCase) const;

    std::filesystem::path folder_;
};

} // namespace plumbline
