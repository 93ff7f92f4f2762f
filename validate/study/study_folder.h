// The results of a study on disk:
//
//     FOLDER/study.json           whose they are
//     FOLDER/cases/ID.json        one a case, written whole when it is done
//     FOLDER/results.csv          a row a case and technique, made of them
//     FOLDER/report/              made of that
#pragma once

#include "validate/study/study_cases.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace plumbline {

class StudyFolder {
  public:
    /// Makes the folder. Throws InputError if it can't be written, or holds the results of another study or
    /// other files.
    StudyFolder(std::filesystem::path folder, const Study& study);
    /// Of a study that was run. Throws InputError if there is none, or of another study.
    static StudyFolder open(std::filesystem::path folder, const Study& study);

    const std::filesystem::path& path() const { return folder_; }
    /// JSON: {"scene", "values", "changes", "seconds", "error", "again", "reference", "fit", "techniques":
    /// [{"name", "result"}], "pairs": [{"first", "second", "result"}]}; `error` is null or why there is
    /// nothing else.
    ///
    /// What is known of a case: nothing if it wasn't run, was cut short, or failed for a reason that may have
    /// gone (`again`).
    std::optional<nlohmann::json> outcomeOf(const StudyCase& studyCase) const;
    void store(const StudyCase& studyCase, const nlohmann::json& outcome) const;

  private:
    explicit StudyFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
    std::filesystem::path fileOf(const StudyCase& studyCase) const;

    std::filesystem::path folder_;
};

} // namespace plumbline
