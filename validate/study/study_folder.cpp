#include "validate/study/study_folder.h"

#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/core/replace_file.h"
#include "validate/results/json_text.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <initializer_list>

namespace plumbline {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* kMark = "study.json";
constexpr std::chrono::seconds kSetupLimit(60); // it takes milliseconds

/// Name of the study whose results the folder contains; nullopt if there are none.
std::optional<std::string> studyIn(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_regular_file(folder / kMark, error)) return std::nullopt;
    const json mark = parseJson((folder / kMark).string(), readWholeFile(folder / kMark));
    const bool good = mark.is_object() && mark.contains("study") && mark["study"].is_string();
    if (!good) throw InputError((folder / kMark).string(), "is damaged", "another folder for the results");
    return mark["study"].get<std::string>();
}

void refuseOther(const fs::path& folder, const std::string& found, const Study& study) {
    if (found != study.name)
        throw InputError(folder.string(), fmt::format("contains the results of study '{}'", found),
                         fmt::format("those of '{}', or an empty folder", study.name),
                         "choose another with -o");
}

/// Whether a file is there though no study is: what a killed run leaves before it marks the folder is none.
bool holdsOtherFiles(const fs::path& folder) {
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (!isRunsOwnFile(entry->path())) return true;
    return false;
}

/// Throws if the folder contains anything else than results of this study. Returns whether it is marked.
bool requireStudyOrEmpty(const fs::path& folder, const Study& study) {
    const bool others = holdsOtherFiles(folder); // first: another run may be marking it
    const std::optional<std::string> found = studyIn(folder);
    if (found)
        refuseOther(folder, *found, study);
    else if (others)
        throw InputError(folder.string(), "contains files that don't belong to a study",
                         "an empty folder, or a new one");
    return found.has_value();
}

bool areResults(const json& outcome, const char* part, std::initializer_list<const char*> names) {
    const auto isResult = [&](const json& entry) {
        return entry.is_object() && entry.contains("result") && entry["result"].is_object() &&
               std::all_of(names.begin(), names.end(),
                           [&](const char* name) { return entry.contains(name) && entry[name].is_string(); });
    };
    const auto found = outcome.find(part);
    return found != outcome.end() && found->is_array() && std::all_of(found->begin(), found->end(), isResult);
}

/// Whether a value has the form of a stored outcome.
bool isOutcome(const json& value) {
    if (!value.is_object() || !value.contains("error")) return false;
    if (value["error"].is_string()) return !value["error"].get<std::string>().empty();
    return value["error"].is_null() && areResults(value, "techniques", {"name"}) &&
           areResults(value, "pairs", {"first", "second"});
}

} // namespace

StudyFolder::StudyFolder(fs::path folder, const Study& study) : folder_(std::move(folder)) {
    requireStudyOrEmpty(folder_, study); // before anything is created in it
    // Two runs may begin at once: the second waits until the first has marked it.
    requireWritableFolder(folder_);
    const auto setup = FileLock::acquire(folder_, kMark, LockKind::Exclusive, kSetupLimit);
    if (!setup)
        throw MachineError(folder_.string(), "another run doesn't stop setting it up", "one that ends");
    // The mark comes first: a run killed after it finds its own folder again.
    if (!requireStudyOrEmpty(folder_, study))
        replaceFile(folder_ / kMark, json{{"study", study.name}}.dump() + "\n");
    requireWritableFolder(folder_ / "cases");
}

StudyFolder StudyFolder::open(fs::path folder, const Study& study) {
    const auto found = studyIn(folder);
    if (!found)
        throw InputError(folder.string(), "contains no results of a study",
                         fmt::format("the folder of 'plumbline study run {}'", study.name));
    refuseOther(folder, *found, study);
    return StudyFolder(std::move(folder));
}

fs::path StudyFolder::fileOf(const StudyCase& studyCase) const {
    return folder_ / "cases" / (studyCase.id + ".json");
}

std::optional<json> StudyFolder::outcomeOf(const StudyCase& studyCase) const {
    std::error_code error;
    if (!fs::exists(fileOf(studyCase), error)) return std::nullopt;
    // Files are written atomically. One that is damaged anyway is computed again.
    try {
        const fs::path file = fileOf(studyCase);
        json outcome = parseJson(file.string(), readWholeFile(file));
        if (!isOutcome(outcome) || outcome.contains("again")) return std::nullopt;
        return outcome;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

std::optional<FileLock> StudyFolder::claim(const StudyCase& studyCase) const {
    return FileLock::acquire(folder_ / "cases", studyCase.id);
}

void StudyFolder::store(const StudyCase& studyCase, const json& outcome) const {
    replaceFile(fileOf(studyCase), outcome.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

} // namespace plumbline
