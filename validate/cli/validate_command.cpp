#include "scenes/core/error.h"
#include "scenes/core/replace_file.h"
#include "scenes/frame/frame_exr.h"
#include "scenes/frame/scene_metadata.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/realtime_arguments.h"
#include "validate/cli/reference_arguments.h"
#include "validate/cli/report_arguments.h"
#include "validate/cli/requirements.h"
#include "validate/cli/scene_arguments.h"
#include "validate/cli/shared.h"
#include "validate/cli/thread_arguments.h"
#include "validate/cli/trial.h"
#include "validate/compare/frame_metadata.h"
#include "validate/results/output_files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <functional>
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

#ifdef PLUMBLINE_GL
// For timing all techniques of a run together: a third of what comparing and painting them takes.
constexpr double kTimingBudgetMs = 4000;

/// The places a run writes to, checked when made.
struct OutputFolder {
    std::filesystem::path folder, frames, report;
    std::set<std::string> taken; // frames written, without their suffix

    OutputFolder(const std::optional<std::filesystem::path>& given, const Scene& scene)
        : folder(given ? *given : std::filesystem::path("plumbline-out") / safeFileName(scene.name)),
          frames(folder / "frames"), report(folder / "report") {
        for (const auto& each : {folder, frames, report})
            requireWritableFolder(each);
    }

    /// A file of its own for each name, though two may be safe in the same way.
    std::filesystem::path newFrameFile(const std::string& technique) {
        const std::string stem = safeFileName(technique);
        std::string unique = stem;
        for (int number = 2; !taken.insert(unique).second; ++number)
            unique = fmt::format("{}_{}", stem, number);
        return frames / (unique + ".exr");
    }

    void write(const Results& results, Report& page, bool last) const {
        replaceFile(folder / "results.json", toJson(results));
        replaceFile(folder / "results.csv", toCsv(results));
        page.write(results, last);
    }
};

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
References drawReferences(const Scene& scene, ReferenceOptions options, BaseChoice choice,
                          Progress& progress) {
    References references;
    const bool microTriangles = options.microAttributes;
    if (choice == BaseChoice::Both) {
        options.base = Base::Proxy;
        options.microAttributes = false;
        references.proxyFrame = drawReference(scene, options, progress, references.proxySummary, nullptr);
    }
    options.base = choice == BaseChoice::Proxy ? Base::Proxy : Base::Limit;
    options.microAttributes = microTriangles;
    references.base = choice == BaseChoice::Proxy ? "proxy" : "limit";
    references.frame = drawReference(scene, options, progress, references.summary,
                                     microTriangles ? &references.scene : nullptr);
    return references;
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

/// Compares, paints and writes the frame, side by side: each of it takes longer than many techniques take to
/// draw.
void judge(Trial& trial, const References& references, const Scene& scene, OutputFolder& output,
           Report& report) {
    const std::filesystem::path file = output.newFrameFile(trial.outcome.name);
    tbb::parallel_invoke([&] { writeFrame(trial.frame, file); },
                         [&] {
                             compareTrial(trial, references.frame, scene);
                             report.addTechnique(trial.outcome, references.frame, trial.frame);
                             dropDepth(trial.outcome.comparison);
                             if (!references.proxyFrame) return;
                             trial.outcome.againstProxy = compareFrames(*references.proxyFrame, trial.frame,
                                                                        objectsOf(scene), scene.camera);
                             dropDepth(*trial.outcome.againstProxy);
                         });
}

/// Frames and pictures of the references.
void writeReferences(const References& references, Results& results, OutputFolder& output, Report& report) {
    writeFrame(references.frame, output.newFrameFile("reference"));
    report.addReference(references.frame);
    if (!references.proxyFrame) return;
    writeFrame(*references.proxyFrame, output.newFrameFile("reference_proxy"));
    report.addBaseGap(results.proxy->gap, references.frame, *references.proxyFrame);
    dropDepth(results.proxy->gap);
}

int runValidate(const Arguments& arguments) {
    const ThreadLimit limit(arguments.threads.threads);
    Progress progress;
    progress.step("reading the scene");
    const std::filesystem::path sceneFile = findScene(arguments.scene.scene);
    const Scene scene = readScene(sceneFile, arguments.scene.changes);
    printWarnings(scene.warnings);
    const auto requirements = readRequirements(arguments.requirements.require, scene.requirements);
    checkNames(requirements, scene);
    const auto settings = parseSettings(arguments.realtime.settings);
    const auto techniques = chosenTechniques(arguments.realtime.techniques, settings);
    const BaseChoice base = parseBase(arguments.reference.base, true);
    ReferenceOptions options = arguments.reference.options();
    options.microAttributes =
        std::any_of(techniques.begin(), techniques.end(), std::mem_fn(&ChosenTechnique::isControl));
    WorkerOptions worker = workerOptions(sceneFile, scene, arguments.realtime, arguments.threads.threads);
    worker.gl.timingBudgetMs =
        std::min(worker.gl.timingBudgetMs, kTimingBudgetMs / static_cast<double>(techniques.size()));
    OutputFolder output(arguments.output, scene);

    // The reference comes before GL starts, so that its peak memory is its own.
    const References references = drawReferences(scene, options, base, progress);
    progress.step("starting OpenGL");
    TechniqueDrawer drawer(scene, worker, techniques);
    progress.say(certificateLine(references.summary.certificate));
    if (references.proxyFrame)
        progress.say(certificateLine(references.proxySummary.certificate, " of the reference on the proxy"));

    removeOldResults(output.folder);
    Results results{programName(),
                    summaryOf(scene),
                    references.base,
                    references.summary,
                    compareBases(references, scene),
                    {}};
    Report report(output.report, arguments.report.options());
    writeReferences(references, results, output, report);
    int exitCode = kExitDone;
    bool requirementsReached = true;
    std::set<std::string> warned;
    for (const ChosenTechnique& chosen : techniques) {
        progress.step(
            fmt::format("{} of {}: {}", results.techniques.size() + 1, techniques.size(), chosen.name));
        Trial trial =
            tryTechnique(chosen, drawer, references.scene ? &references.scene->microMeshes() : nullptr);
        if (!trial.outcome.error) judge(trial, references, scene, output, report);
        if (!trial.outcome.control) requirementsReached &= holdRequirements(requirements, trial.outcome);
        for (const std::string& warning : trial.warnings)
            if (warned.insert(warning).second) printWarnings({warning});
        if (exitCode == kExitDone) exitCode = trial.exitCode;
        results.techniques.push_back(std::move(trial.outcome));
        // Whole after every technique: a run that is stopped leaves what was finished.
        output.write(results, report, results.techniques.size() == techniques.size());
    }
    fmt::print("{}\n{}", toTable(results), reportLine(output.report / "index.html"));
    return exitCode == kExitDone && !requirementsReached ? kExitThreshold : exitCode;
}

#else

int runValidate(const Arguments&) {
    throw MachineError("validate", "this program was built without OpenGL (preset no-gl)", "a build with it",
                       "'plumbline reference' and 'plumbline compare' work without");
}

#endif

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    arguments->scene.addOptionalTo(command);
    command.add_option("-o", arguments->output, "Folder of the results (default: plumbline-out/SCENE)")
        ->type_name("DIR");
    arguments->report.addTo(command);
    arguments->reference.addTo(command, "limit|proxy|both");
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
