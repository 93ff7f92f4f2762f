#include "../../scenes/error.h"
#include "../../scenes/frame_exr.h"
#include "../../scenes/replace_file.h"
#include "../../scenes/scene_file.h"
#include "../../scenes/scene_metadata.h"
#include "../frame_metadata.h"
#include "../output_files.h"
#include "../report.h"
#include "shared.h"

#include <fmt/format.h>

#include <set>

namespace plumbline {

#ifdef PLUMBLINE_GL
namespace {

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

    /// Results of an earlier run: gone before the first file of this one, so that no stopped run can pass for
    /// whole.
    void removeOldResults() const {
        for (const auto& file : {folder / "results.json", folder / "results.csv", report / "index.html"}) {
            std::error_code error;
            std::filesystem::remove(file, error);
            if (error) throw InputError(file.string(), "can't be replaced", "the name of a file");
        }
    }

    /// A file of its own for each name, though two may be safe in the same way.
    std::filesystem::path newFrameFile(const std::string& technique) {
        const std::string stem = safeFileName(technique);
        std::string unique = stem;
        for (int number = 2; !taken.insert(unique).second; ++number)
            unique = fmt::format("{}_{}", stem, number);
        return frames / (unique + ".exr");
    }

    void write(const Results& results, const Report& page) const {
        replaceFile(folder / "results.json", toJson(results));
        replaceFile(folder / "results.csv", toCsv(results));
        page.write(results);
    }
};

std::vector<std::string> limitsOf(const TechniqueRequest& request) {
    try {
        return techniqueInfo(request).limits;
    } catch (const InputError&) {
        return {};
    }
}

/// One technique held against the reference frame.
struct Trial {
    TechniqueOutcome outcome;
    Frame frame;
    int exitCode = kExitDone;
};

Trial tryTechnique(const TechniqueRequest& request, const std::map<std::string, std::string>& settings,
                   RealtimeRenderer& renderer, const ReferenceScene& reference, const Frame& referenceFrame,
                   const Scene& scene) {
    Trial trial;
    trial.outcome.name = displayName(request, settings);
    trial.outcome.limits = limitsOf(request);
    try {
        const auto* microMeshes = drawsMicroTriangles(request) ? &reference.microMeshes() : nullptr;
        TechniqueResult result = renderer.render(request, settings, microMeshes);
        trial.outcome.parameters = result.parameters;
        trial.outcome.backend = result.backend;
        trial.outcome.renderer = result.renderer;
        trial.outcome.msMedian = result.msMedian;
        trial.outcome.msRuns = result.msRuns;
        trial.outcome.timer = result.timer;
        trial.frame = std::move(result.frame);
        trial.outcome.comparison = compareFrames(referenceFrame, trial.frame, objectsOf(scene), scene.camera);
    } catch (const InputError& error) {
        trial.outcome.error = error.what();
        trial.exitCode = kExitBadInput;
    } catch (const MachineError& error) {
        trial.outcome.error = error.what();
        trial.exitCode = kExitMachine;
    }
    return trial;
}

} // namespace

int runValidate(const ValidateArguments& arguments) {
    Progress progress;
    progress.step("reading the scene");
    const Scene scene = readScene(findScene(arguments.reference.scene));
    const auto settings = parseSettings(arguments.realtime.settings);
    const auto requests = chosenTechniques(arguments.realtime.techniques, settings);
    checkSettings(settings, requests);
    ReferenceOptions options = referenceOptions(arguments.reference);
    for (const TechniqueRequest& request : requests)
        options.microAttributes |= drawsMicroTriangles(request);
    const GlOptions gl = glOptions(arguments.realtime);
    OutputFolder output(arguments.output, scene);

    // The reference comes before GL starts, so that its peak memory is its own.
    progress.step("reference: tessellating");
    ReferenceScene reference(scene, options);
    progress.step("reference: tracing");
    const Frame referenceFrame = reference.render();
    Results results{programName(), summaryOf(scene), summaryOf(reference.stats(), referenceFrame), {}};
    progress.step("starting OpenGL");
    RealtimeRenderer renderer(scene, gl);
    progress.say(certificateLine(results.reference.certificate));

    output.removeOldResults();
    writeFrame(referenceFrame, output.newFrameFile("reference"));
    Report report(output.report);
    report.addReference(referenceFrame);
    int exitCode = kExitDone;
    for (const TechniqueRequest& request : requests) {
        progress.step(fmt::format("{} of {}: {}", results.techniques.size() + 1, requests.size(),
                                  displayName(request, settings)));
        Trial trial = tryTechnique(request, settings, renderer, reference, referenceFrame, scene);
        if (!trial.outcome.error) {
            writeFrame(trial.frame, output.newFrameFile(trial.outcome.name));
            report.addTechnique(trial.outcome, referenceFrame, trial.frame);
        }
        trial.outcome.comparison.referenceDepth.clear(); // painted; no longer needed
        trial.outcome.comparison.testDepth.clear();
        if (exitCode == kExitDone) exitCode = trial.exitCode;
        results.techniques.push_back(std::move(trial.outcome));
        output.write(results,
                     report); // whole after every technique: a run that is stopped leaves what was finished
    }
    fmt::print("{}\n{}", toTable(results),
               fmt::format("report: {}\n", (output.report / "index.html").string()));
    return exitCode;
}

#else

int runValidate(const ValidateArguments&) {
    throw MachineError("validate", "this program was built without OpenGL (preset no-gl)", "a build with it",
                       "'plumbline reference' and 'plumbline compare' work without");
}

#endif

} // namespace plumbline
