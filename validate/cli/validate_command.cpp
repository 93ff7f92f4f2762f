#include "realtime/gl/gl_probe.h"
#include "scenes/core/error.h"
#include "scenes/core/program_name.h"
#include "scenes/core/replace_file.h"
#include "scenes/frame/frame_exr.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/object_info.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/frame_memory.h"
#include "validate/cli/progress.h"
#include "validate/cli/realtime_arguments.h"
#include "validate/cli/reference_arguments.h"
#include "validate/cli/report_arguments.h"
#include "validate/cli/requirements.h"
#include "validate/cli/run_summaries.h"
#include "validate/cli/scene_arguments.h"
#include "validate/cli/thread_arguments.h"
#include "validate/cli/trial.h"
#include "validate/results/output_files.h"
#include "validate/results/unique_file_names.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <memory>
#include <set>

namespace plumbline {
namespace {

struct Arguments {
    SceneArguments scene;
    std::optional<std::filesystem::path> output; // folder
    ReportArguments report;
    ReferenceArguments reference;
    RealtimeArguments realtime;
    RequirementArguments requirements;
    ThreadArguments threads;
};

// For timing all techniques of a run together: a third of what comparing and painting them takes.
constexpr double kTimingBudgetMs = 4000;

/// The places a run writes to, checked and claimed when made.
struct OutputFolder {
    std::filesystem::path folder, frames, report;
    FileLock claim, framesClaim; // while the run lasts
    UniqueFileNames frameNames;  // without their suffix

    OutputFolder(const std::optional<std::filesystem::path>& given, const Scene& scene)
        : folder(given ? *given : std::filesystem::path("plumbline-out") / safeFileName(scene.name)),
          frames(folder / "frames"), report(folder / "report"), claim(claimFolder(folder)),
          framesClaim(claimFolder(frames)) {
        requireWritableFolder(report);
        for (const char* name : {"results.json", "results.csv", "report/index.html", "frames/reference.exr"})
            requireWritableFile(folder / name, scene.files);
    }

    /// A file of its own for each name, though two may be safe in the same way.
    std::filesystem::path newFrameFile(const std::string& technique) {
        return frames / (frameNames.add(safeFileName(technique)) + ".exr");
    }
};

/// What a run is about, read and checked before any work.
struct Task {
    std::filesystem::path sceneFile;
    Scene scene;
    std::vector<Requirement> requirements;
    std::vector<ChosenTechnique> techniques;
};

Task readTask(const Arguments& arguments) {
    Task task;
    task.sceneFile = findScene(arguments.scene.scene);
    task.scene = readScene(task.sceneFile, arguments.scene.changes);
    printWarnings(task.scene.warnings);
    task.requirements = requirementsOf(arguments.requirements, task.scene);
    task.techniques = chosenTechniques(arguments.realtime.techniques, arguments.realtime.settings);
    requireFrameMemory(task.scene, FrameUse::Compared);
    return task;
}

WorkerOptions workerOptions(const Task& task, const Arguments& arguments) {
    WorkerOptions worker =
        workerOptions(task.sceneFile, task.scene, arguments.realtime, arguments.threads.threads);
    worker.gl.timingBudgetMs =
        std::min(worker.gl.timingBudgetMs, kTimingBudgetMs / static_cast<double>(task.techniques.size()));
    return worker;
}

/// The true frame, and with both bases the other one.
struct References {
    std::string base; // of `frame`: "limit" or "proxy"
    Frame frame;
    ReferenceSummary summary;
    std::unique_ptr<ReferenceScene> scene; // that drew `frame`; null if nobody needs its micro-triangles
    std::optional<Frame> proxyFrame;       // with both: drawn on the proxy
    ReferenceSummary proxySummary;
};

/// Frees what drew the frame unless `kept` takes it.
Frame drawReference(const Scene& scene, const ReferenceOptions& options, Progress& progress,
                    ReferenceSummary& summary, std::unique_ptr<ReferenceScene>* kept) {
    const char* where = options.base == Base::Proxy ? "reference on the proxy" : "reference";
    progress.step(fmt::format("{}: tessellating", where));
    auto reference = std::make_unique<ReferenceScene>(scene, options);
    printWarnings(reference->stats().warnings);
    progress.step(fmt::format("{}: tracing", where));
    Frame frame = reference->render();
    summary = summaryOf(reference->stats(), frame);
    if (kept) *kept = std::move(reference);
    return frame;
}

/// The proxy goes first, so that its micro-triangles are gone before those on the limit surface, which the
/// control technique may need, are made: memory never holds both.
References drawReferences(const Task& task, const ReferenceArguments& arguments, Progress& progress) {
    References references;
    ReferenceOptions options = arguments.options;
    const BaseChoice choice = arguments.base;
    const bool microTriangles = anyControl(task.techniques);
    if (choice == BaseChoice::Both) {
        options.base = Base::Proxy;
        references.proxyFrame =
            drawReference(task.scene, options, progress, references.proxySummary, nullptr);
    }
    options.base = choice == BaseChoice::Proxy ? Base::Proxy : Base::Limit;
    options.microAttributes = microTriangles;
    references.base = baseName(options.base);
    references.frame = drawReference(task.scene, options, progress, references.summary,
                                     microTriangles ? &references.scene : nullptr);
    return references;
}

void sayCertificates(const References& references, Progress& progress) {
    progress.say(certificateLine(references.summary.certificate));
    if (references.proxyFrame)
        progress.say(certificateLine(references.proxySummary.certificate, " of the reference on the proxy"));
}

/// Compares the proxy's reference with the limit one.
std::optional<ProxyReference> compareBases(const References& references, const Scene& scene) {
    if (!references.proxyFrame) return std::nullopt;
    return ProxyReference{references.proxySummary, compareFrames(references.frame, *references.proxyFrame,
                                                                 objectsOf(scene), scene.camera)};
}

/// Painted, the planes are no longer needed.
void dropDepth(Comparison& comparison) {
    comparison.referenceDepth = {};
    comparison.testDepth = {};
}

/// What a run leaves behind, technique by technique.
struct Output {
    OutputFolder& folder;
    Results results;
    Report report;

    /// Frames and pictures of the references.
    void addReferences(const References& references) {
        writeFrame(references.frame, folder.newFrameFile("reference"));
        report.addReference(references.frame);
        if (!references.proxyFrame) return;
        writeFrame(*references.proxyFrame, folder.newFrameFile("reference_proxy"));
        report.addBaseGap(results.proxy->gap, references.frame, *references.proxyFrame);
        dropDepth(results.proxy->gap);
    }

    void write(bool last) {
        replaceFile(folder.folder / "results.json", toJson(results));
        replaceFile(folder.folder / "results.csv", toCsv(results));
        report.write(results, last);
    }
};

Results beginResults(const Scene& scene, const References& references) {
    return {programName(),
            summaryOf(scene),
            references.base,
            references.summary,
            compareBases(references, scene),
            {}};
}

/// Compares, paints and writes the frame, side by side: each of it takes longer than many techniques take to
/// draw.
void judge(Trial& trial, const References& references, const Scene& scene, Output& output) {
    const std::filesystem::path file = output.folder.newFrameFile(trial.outcome.name);
    tbb::parallel_invoke([&] { writeFrame(trial.frame, file); },
                         [&] {
                             compareTrial(trial, references.frame, scene);
                             output.report.addTechnique(trial.outcome, references.frame, trial.frame);
                             dropDepth(trial.outcome.comparison);
                             if (!references.proxyFrame) return;
                             trial.outcome.againstProxy = compareFrames(*references.proxyFrame, trial.frame,
                                                                        objectsOf(scene), scene.camera);
                             dropDepth(*trial.outcome.againstProxy);
                         });
}

/// Each text once in a run.
void printNewWarnings(const std::vector<std::string>& warnings, std::set<std::string>& printed) {
    for (const std::string& warning : warnings)
        if (printed.insert(warning).second) printWarnings({warning});
}

/// One technique after the other. Returns the exit code of the run.
int judgeTechniques(const Task& task, const References& references, TechniqueDrawer& drawer, Output& output,
                    Progress& progress) {
    const std::vector<MicroMesh>* microMeshes = references.scene ? &references.scene->microMeshes() : nullptr;
    std::vector<TechniqueOutcome>& outcomes = output.results.techniques;
    int exitCode = kExitDone;
    bool requirementsReached = true;
    std::set<std::string> warned;
    for (const ChosenTechnique& chosen : task.techniques) {
        progress.step(fmt::format("{} of {}: {}", outcomes.size() + 1, task.techniques.size(), chosen.name));
        Trial trial = tryTechnique(chosen, drawer, microMeshes);
        if (!trial.outcome.error) judge(trial, references, task.scene, output);
        if (!trial.outcome.control) requirementsReached &= holdRequirements(task.requirements, trial.outcome);
        printNewWarnings(trial.warnings, warned);
        if (exitCode == kExitDone) exitCode = trial.exitCode;
        outcomes.push_back(std::move(trial.outcome));
        // Whole after every technique: a run that is stopped leaves what was finished.
        output.write(outcomes.size() == task.techniques.size());
    }
    return exitCode == kExitDone && !requirementsReached ? kExitThreshold : exitCode;
}

int runValidate(const Arguments& arguments) {
    requireGlBuild("validate", "a build with it",
                   "'plumbline reference' and 'plumbline compare' work without");
    const ThreadLimit limit(arguments.threads.threads);
    Progress progress;
    progress.step("reading the scene");
    const Task task = readTask(arguments);
    OutputFolder folder(arguments.output, task.scene);
    // The reference comes before GL starts, so that its peak memory is its own.
    const References references = drawReferences(task, arguments.reference, progress);
    progress.step("starting OpenGL");
    TechniqueDrawer drawer(task.scene, workerOptions(task, arguments), task.techniques);
    sayCertificates(references, progress);

    removeOldResults(folder.folder);
    Output output{folder, beginResults(task.scene, references),
                  Report(folder.report, arguments.report.options())};
    output.addReferences(references);
    const int exitCode = judgeTechniques(task, references, drawer, output, progress);
    fmt::print("{}\n{}", toTable(output.results), reportLine(folder.report / "index.html"));
    return exitCode;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    arguments->scene.addOptionalTo(command);
    command.add_option("-o", arguments->output, "Folder of the results (default: plumbline-out/SCENE)")
        ->type_name("DIR");
    arguments->report.addTo(command);
    arguments->reference.addTo(command, true);
    arguments->realtime.addTo(command);
    arguments->requirements.addTo(command);
    arguments->threads.addTo(command);
    return [arguments] { return runValidate(*arguments); };
}

} // namespace

Command validateCommand() {
    return {"validate", "Compare techniques with the displaced reference: metrics and report", addOptions};
}

} // namespace plumbline
