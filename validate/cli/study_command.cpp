#include "realtime/gl/gl_probe.h"
#include "reference/reference.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"
#include "scenes/core/replace_file.h"
#include "validate/cli/case_pool.h"
#include "validate/cli/chosen_techniques.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/gl_arguments.h"
#include "validate/cli/option_values.h"
#include "validate/cli/progress.h"
#include "validate/cli/realtime_arguments.h"
#include "validate/cli/thread_arguments.h"
#include "validate/study/study_report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <set>
#include <span>
#include <thread>

namespace plumbline {
namespace {

struct Arguments {
    std::string study;                           // path, or a name in validate/studies/
    std::optional<std::filesystem::path> output; // folder
    int jobs = 0;                                // cases at a time; 0: as many as there are cores
    bool yes = false;                            // also very many cases
    GlArguments gl;
    DrawMemoryArguments drawMemory; // of each drawing process
    ThreadArguments threads;        // all of them together
};

using nlohmann::json;

constexpr uint64_t kManyCases = 2000;     // an hour and more
constexpr uint64_t kMostCases = 10000000; // what a list of them may take of memory
constexpr std::chrono::seconds kBetweenTables(10);

/// A study of very many cases only if the user said so.
Study readStudyWithConsent(const Arguments& arguments) {
    Study study = readStudy(findStudy(arguments.study));
    const uint64_t count = caseCount(study);
    if (count > kMostCases)
        throw InputError(arguments.study, fmt::format("has {} cases", count),
                         fmt::format("at most {}", kMostCases));
    if (count > kManyCases && !arguments.yes)
        throw InputError(arguments.study, fmt::format("has {} cases", count),
                         fmt::format("at most {} without --yes", kManyCases));
    return study;
}

std::filesystem::path outputFolder(const Study& study, const Arguments& arguments) {
    return arguments.output.value_or(std::filesystem::path("plumbline-out") / ("study-" + study.name));
}

int coreCount() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Names and settings of every grid, before anything is drawn.
void checkTechniques(const Study& study) {
    for (const StudyGrid& grid : study.grids) {
        const auto settings = parseSettings(grid.settings);
        std::vector<std::string> names;
        for (const StudyTechnique& technique : grid.techniques)
            names.push_back(technique.name);
        for (const ChosenTechnique& chosen : chosenTechniques(names, settings))
            (void)chosen.resolved(); // throws for a value it doesn't take
    }
}

/// Cases that are computed at a time share what is free.
uint64_t drawMemory(const Arguments& arguments, int jobs) {
    if (arguments.drawMemory.bytes > 0) return arguments.drawMemory.bytes;
    return static_cast<uint64_t>(kMemoryShare * static_cast<double>(freeMemoryBytes()) / jobs);
}

/// Throws for what would be wrong in every case.
CaseOptions caseOptions(const Study& study, const Arguments& arguments, int jobs) {
    CaseOptions options;
    options.referenceBytes = parseMemorySize("memory", study.memory);
    options.drawBytes = drawMemory(arguments, jobs);
    options.referenceErrorPx =
        study.errorPx.empty() ? ReferenceOptions().errorPx : parseErrorPx(study.errorPx);
    options.gl = arguments.gl.options;
    const int threads = arguments.threads.threads;
    options.threads = std::max(1, (threads > 0 ? threads : coreCount()) / jobs);
    options.timeLimitSeconds = study.timeLimitSeconds;
    return options;
}

/// What is known, and what is left to do.
struct StudyState {
    std::vector<StudyRow> rows;
    std::vector<StudyCase> open; // not worked out, or not for a reason that may have gone
    size_t failed = 0;           // also in part: a technique
    size_t computed = 0;         // by this run

    void add(const StudyCase& studyCase, const json& outcome) {
        bool anyError = false;
        for (StudyRow& row : rowsOf(studyCase, outcome)) {
            anyError |= !row.error.empty();
            rows.push_back(std::move(row));
        }
        failed += anyError;
    }
};

StudyState readState(const StudyFolder& folder, const std::vector<StudyCase>& cases) {
    StudyState state;
    for (const StudyCase& studyCase : cases) {
        if (const auto outcome = folder.outcomeOf(studyCase))
            state.add(studyCase, *outcome);
        else
            state.open.push_back(studyCase);
    }
    return state;
}

std::string timeLeft(std::chrono::steady_clock::time_point start, size_t done, size_t all) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    const double seconds = spent.count() / static_cast<double>(done) * static_cast<double>(all - done);
    return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

std::filesystem::path tableFile(const StudyFolder& folder) {
    return folder.path() / "results.csv";
}

void writeTable(const StudyFolder& folder, const StudyState& state) {
    replaceFile(tableFile(folder), studyCsv(state.rows));
}

/// A case's failures, each text once: what fails in one often fails in all.
void tell(const StudyCase& studyCase, std::span<const StudyRow> rows, std::set<std::string>& said,
          Progress& progress) {
    for (const StudyRow& row : rows)
        if (!row.error.empty() && said.insert(errorOf(row)).second)
            progress.say(
                fmt::format("{} {}: {}", studyCase.scene, fmt::join(studyCase.changes, " "), errorOf(row)));
}

void runOpenCases(const StudyFolder& folder, StudyState& state, int jobs, const CaseOptions& options,
                  Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    auto lastTable = start;
    size_t done = 0;
    std::set<std::string> said;
    progress.step(fmt::format("{} cases, {} at a time", state.open.size(), jobs));
    runCases(
        folder, state.open, jobs, options, [&](const StudyCase& studyCase, const FinishedCase& finished) {
            const size_t before = state.rows.size();
            state.add(studyCase, finished.outcome);
            state.computed += finished.computedHere;
            ++done;
            tell(studyCase, std::span<const StudyRow>(state.rows).subspan(before), said, progress);
            progress.step(fmt::format("{} of {} cases, {} failed, about {} left", done, state.open.size(),
                                      state.failed, timeLeft(start, done, state.open.size())));
            const auto now = std::chrono::steady_clock::now();
            if (now - lastTable < kBetweenTables) return;
            writeTable(folder, state);
            lastTable = now;
        });
}

void printSummary(const StudyState& state, size_t cases, size_t computed, double seconds,
                  const std::filesystem::path& table) {
    fmt::print("{} cases: {} computed in {:.0f} s, {} already stored, {} failed\n{}\n", cases, computed,
               seconds, cases - computed, state.failed + state.open.size(), table.string());
}

int exitCodeOf(const StudyState& state) {
    if (state.failed > 0) return kExitBadInput;
    return state.open.empty() ? kExitDone : kExitMachine;
}

int runStudy(const Arguments& arguments) {
    requireGlBuild("study", "a build with it");
    const ThreadLimit limit(arguments.threads.threads);
    Progress progress;
    progress.step("reading the study");
    const Study study = readStudyWithConsent(arguments);
    checkTechniques(study);
    const int jobs = arguments.jobs > 0 ? arguments.jobs : coreCount();
    const CaseOptions options = caseOptions(study, arguments, jobs);
    const StudyFolder folder(outputFolder(study, arguments), study);
    const std::vector<StudyCase> cases = casesOf(study, techniquesHash);
    StudyState state = readState(folder, cases);
    const auto start = std::chrono::steady_clock::now();
    if (!state.open.empty()) runOpenCases(folder, state, jobs, options, progress);
    const size_t computed = state.computed;
    // In the study's order, whatever order they were done in.
    state = readState(folder, cases);
    writeTable(folder, state);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    printSummary(state, cases.size(), computed, spent.count(), tableFile(folder));
    return exitCodeOf(state);
}

int runStudyReport(const Arguments& arguments) {
    requireGlBuild("study", "a build with it");
    const Study study = readStudyWithConsent(arguments);
    const StudyFolder folder = StudyFolder::open(outputFolder(study, arguments), study);
    const std::vector<StudyCase> cases = casesOf(study, techniquesHash);
    const StudyState state = readState(folder, cases);
    if (state.rows.empty())
        throw InputError(folder.path().string(), "contains no finished case of this study",
                         fmt::format("'plumbline study run {}' before", arguments.study));
    writeTable(folder, state);
    writeStudyReport(study, state.rows, cases.size(), state.open.size(), folder.path() / "report");
    fmt::print("{}\n", (folder.path() / "report" / "index.html").string());
    return kExitDone;
}

void addCommonOptions(CLI::App& command, Arguments& study) {
    command.add_option("STUDY", study.study, "A study file or a name of validate/studies/")->required();
    command.add_option("-o", study.output, "Folder of its results (default: plumbline-out/study-NAME)")
        ->type_name("DIR");
    command.add_flag("--yes", study.yes, "Allow more than 2000 cases");
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.require_subcommand(1);
    CLI::App* run = command.add_subcommand("run", "Compute every case without results");
    addCommonOptions(*run, *arguments);
    run->add_option("--jobs", arguments->jobs, "Number of parallel cases (default: number of cores)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    arguments->gl.addTo(*run);
    arguments->drawMemory.addTo(*run);
    arguments->threads.addTo(*run);
    CLI::App* report =
        command.add_subcommand("report", "Write tables and plots of the cases computed so far");
    addCommonOptions(*report, *arguments);
    return
        [arguments, report] { return report->parsed() ? runStudyReport(*arguments) : runStudy(*arguments); };
}

} // namespace

Command studyCommand() {
    return {"study", "Sweep over scenes, values and techniques, with tables and plots", addOptions};
}

} // namespace plumbline
