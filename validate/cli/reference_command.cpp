#include "reference/export/mesh_file.h"
#include "scenes/core/error.h"
#include "scenes/core/program_name.h"
#include "scenes/core/replace_file.h"
#include "scenes/frame/frame_exr.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/frame_memory.h"
#include "validate/cli/progress.h"
#include "validate/cli/reference_arguments.h"
#include "validate/cli/run_summaries.h"
#include "validate/cli/scene_arguments.h"
#include "validate/cli/thread_arguments.h"
#include "validate/compare/camera_json.h"
#include "validate/results/output_files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <set>

namespace plumbline {
namespace {

struct Arguments {
    SceneArguments scene;
    std::optional<std::filesystem::path> output;
    ReferenceArguments reference;
    std::optional<std::filesystem::path> meshFile, cameraFile; // .ply or .obj, .json
    ThreadArguments threads;
};

/// Before any work: every file has a name of its own and can be written, and no other run writes it.
std::vector<FileClaim> claimOutputs(const Arguments& arguments, const std::filesystem::path& frameFile,
                                    const Scene& scene) {
    if (arguments.meshFile) requireMeshFileName(*arguments.meshFile);
    std::set<std::filesystem::path> names;
    std::vector<FileClaim> claims;
    for (const auto& file : {std::optional(frameFile), arguments.meshFile, arguments.cameraFile}) {
        if (!file) continue;
        requireWritableFile(*file, scene.files);
        const std::filesystem::path target = linkTarget(*file);
        if (!names.insert(std::filesystem::canonical(folderOf(target)) / target.filename()).second)
            throw InputError(file->string(), "is used for two results", "a separate file for each");
        claims.push_back(claimFile(*file, scene.files));
    }
    return claims;
}

void exportMesh(const std::filesystem::path& file, const Scene& scene, const ReferenceScene& reference) {
    std::vector<MeshFileObject> objects;
    for (size_t k = 0; k < scene.objects.size(); ++k)
        objects.push_back({scene.objects[k].name, &reference.microMeshes()[k]});
    const std::vector<std::string> comments{
        fmt::format("{}, scene {}, {}", programName(), scene.name, scene.hash),
        "world space: right-handed, Y up; s t: texture coordinates, tiled"};
    const MeshFileSize size = writeMeshFile(file, objects, comments);
    fmt::print("{}\n{} triangles, {} vertices; {:.0f} MB\n", file.string(), size.triangles, size.vertices,
               static_cast<double>(size.bytes) / 1e6);
}

void printSummary(const std::filesystem::path& frameFile, const ReferenceStats& stats) {
    fmt::print("{}\n{} micro-triangles; tessellate {:.0f} ms, build {:.0f} ms, trace {:.0f} ms, certify "
               "{:.0f} ms; peak "
               "{:.0f} MB\n",
               frameFile.string(), stats.microTriangles, stats.tessellateMs, stats.buildMs, stats.traceMs,
               stats.certifyMs, static_cast<double>(peakBytes()) / 1e6);
    for (const ReferenceStats::Object& object : stats.objects)
        if (object.rate < object.wantedRate)
            fmt::print("{}: {} segments per control edge of the {} wanted\n", object.name, object.rate,
                       object.wantedRate);
}

void exportCamera(const std::filesystem::path& file, const Scene& scene) {
    replaceFile(file, cameraJson(scene));
    fmt::print("{}\n", file.string());
}

ReferenceOptions referenceOptions(const Arguments& arguments) {
    ReferenceOptions options = arguments.reference.options;
    options.base = arguments.reference.base == BaseChoice::Proxy ? Base::Proxy : Base::Limit;
    options.microAttributes = arguments.meshFile.has_value();
    return options;
}

int runReference(const Arguments& arguments) {
    const ThreadLimit limit(arguments.threads.threads);
    Progress progress;
    progress.step("reading the scene");
    const Scene scene = readScene(findScene(arguments.scene.scene), arguments.scene.changes);
    printWarnings(scene.warnings);
    requireFrameMemory(scene, FrameUse::Reference);
    const std::filesystem::path file = arguments.output.value_or(
        std::filesystem::path("plumbline-out") / safeFileName(scene.name) / "frames" / "reference.exr");
    const std::vector<FileClaim> claims = claimOutputs(arguments, file, scene);

    progress.step("tessellating");
    ReferenceScene reference(scene, referenceOptions(arguments));
    printWarnings(reference.stats().warnings);
    progress.step("tracing");
    const Frame frame = reference.render();
    progress.step("writing");
    writeFrame(frame, file);
    progress.say(certificateLine(summaryOf(reference.stats(), frame).certificate));
    printSummary(file, reference.stats());
    if (arguments.meshFile) { // those of the frame: rendering may have made finer ones
        progress.step("writing the mesh");
        exportMesh(*arguments.meshFile, scene, reference);
    }
    if (arguments.cameraFile) exportCamera(*arguments.cameraFile, scene);
    return kExitDone;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    arguments->scene.addTo(command);
    command.add_option("-o", arguments->output, "The frame's file")->type_name("FILE.exr");
    arguments->reference.addTo(command, false);
    command
        .add_option("--export-mesh", arguments->meshFile,
                    "Also write the displaced triangles, for other renderers")
        ->type_name("FILE.ply|obj");
    command.add_option("--export-camera", arguments->cameraFile, "Also write the camera and the lights")
        ->type_name("FILE.json");
    arguments->threads.addTo(command);
    return [arguments] { return runReference(*arguments); };
}

} // namespace

Command referenceCommand() {
    return {"reference", "Write the reference frame of a scene", addOptions};
}

} // namespace plumbline
