#include "scenes/core/error.h"
#include "scenes/frame/frame_exr.h"
#include "scenes/scene_file/scene_file.h"
#include "validate/cli/shared.h"
#include "validate/cli/technique_drawer.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>

namespace plumbline {

#ifdef PLUMBLINE_GL

int runRealtime(const RealtimeArguments& arguments) {
    if (arguments.techniques.size() != 1)
        throw InputError("realtime", fmt::format("found {} techniques", arguments.techniques.size()),
                         "exactly one --technique", "'plumbline validate' takes several");
    Progress progress;
    progress.step("reading the scene");
    const std::filesystem::path sceneFile = findScene(arguments.scene);
    const Scene scene = readScene(sceneFile, arguments.sceneChanges);
    printWarnings(scene.warnings);
    const auto settings = parseSettings(arguments.settings);
    const auto requests = chosenTechniques(arguments.techniques, settings);
    if (requests.size() != 1) throw InputError("--technique", "found 'all'", "the name of one technique");
    const TechniqueRequest& request = requests[0];
    checkSettings(settings, requests);
    const WorkerOptions worker = workerOptions(sceneFile, scene, arguments);
    const std::filesystem::path file =
        arguments.output.value_or(std::filesystem::path("plumbline-out") / safeFileName(scene.name) /
                                  "frames" / (safeFileName(displayName(request, settings)) + ".exr"));
    requireWritableFile(file, scene.files);

    std::optional<ReferenceScene> reference;
    if (drawsMicroTriangles(request)) {
        progress.step("tessellating");
        ReferenceOptions options;
        options.microAttributes = true;
        reference.emplace(scene, options);
    }
    progress.step("drawing");
    TechniqueDrawer drawer(scene, worker, requests);
    const TechniqueResult result =
        drawer.draw(request, settings, reference ? &reference->microMeshes() : nullptr);
    printWarnings(result.warnings);
    writeFrame(result.frame, file);
    fmt::print("{}\n{} on {} ({}): {:.2f} ms, median of {} ({})\n", file.string(), result.name,
               result.renderer, result.backend, result.msMedian, result.msRuns, result.timer);
    return kExitDone;
}

#else

int runRealtime(const RealtimeArguments&) {
    throw MachineError("realtime", "this program was built without OpenGL (preset no-gl)", "a build with it");
}

#endif

} // namespace plumbline
