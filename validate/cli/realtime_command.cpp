#include "realtime/gl/gl_probe.h"
#include "reference/reference.h"
#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/frame/frame_exr.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/frame_memory.h"
#include "validate/cli/progress.h"
#include "validate/cli/realtime_arguments.h"
#include "validate/cli/scene_arguments.h"
#include "validate/cli/technique_drawer.h"
#include "validate/cli/thread_arguments.h"
#include "validate/metrics/hit_faults.h"
#include "validate/results/output_files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline {
namespace {

struct Arguments {
    SceneArguments scene;
    std::optional<std::filesystem::path> output;
    RealtimeArguments realtime;
    ThreadArguments threads;
};

void requireOneTechnique(const Arguments& arguments) {
    const std::vector<std::string>& texts = arguments.realtime.techniques;
    if (texts.size() != 1)
        throw InputError("realtime", fmt::format("found {} techniques", texts.size()),
                         "exactly one --technique", "'plumbline validate' takes several");
}

/// Where the frame goes.
std::filesystem::path frameFile(const Arguments& arguments, const Scene& scene,
                                const ChosenTechnique& chosen) {
    return arguments.output.value_or(std::filesystem::path("plumbline-out") / safeFileName(scene.name) /
                                     "frames" / (safeFileName(chosen.name) + ".exr"));
}

/// What a control technique draws.
ReferenceScene tessellate(const Scene& scene) {
    ReferenceOptions options;
    options.microAttributes = true;
    return ReferenceScene(scene, options);
}

int runRealtime(const Arguments& arguments) {
    requireGlBuild("realtime", "a build with it");
    const ThreadLimit limit(arguments.threads.threads);
    requireOneTechnique(arguments);
    Progress progress;
    progress.step("reading the scene");
    const std::filesystem::path sceneFile = findScene(arguments.scene.scene);
    const Scene scene = readScene(sceneFile, arguments.scene.changes);
    printWarnings(scene.warnings);
    const auto techniques = chosenTechniques(arguments.realtime.techniques, arguments.realtime.settings);
    if (techniques.size() != 1) throw InputError("--technique", "found 'all'", "the name of one technique");
    const ChosenTechnique& chosen = techniques[0];
    requireFrameMemory(scene, FrameUse::Drawn);
    const std::filesystem::path file = frameFile(arguments, scene, chosen);
    const FileClaim claim = claimFile(file, scene.files);

    std::optional<ReferenceScene> reference;
    if (chosen.isControl()) {
        progress.step("tessellating");
        reference.emplace(tessellate(scene));
    }
    progress.step("drawing");
    TechniqueDrawer drawer(
        scene, workerOptions(sceneFile, scene, arguments.realtime, arguments.threads.threads), techniques);
    const TechniqueResult result =
        drawer.draw(chosen.resolved(), reference ? &reference->microMeshes() : nullptr);
    printWarnings(result.warnings);
    printWarnings(faultSentences(result.frame));
    writeFrame(result.frame, file);
    fmt::print("{}\n{} on {} ({}): {:.2f} ms, median of {} ({})\n", printable(file.string()),
               printable(result.name), result.renderer, result.backend, result.msMedian, result.msRuns,
               result.timer);
    return kExitDone;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    arguments->scene.addTo(command);
    command.add_option("-o", arguments->output, "The frame's file")->type_name("FILE.exr");
    arguments->realtime.addTo(command);
    arguments->threads.addTo(command);
    return [arguments] { return runRealtime(*arguments); };
}

} // namespace

Command realtimeCommand() {
    return {"realtime", "Write the frame of one technique", addOptions};
}

} // namespace plumbline
