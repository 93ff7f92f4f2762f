#include "../../scenes/frame_exr.h"
#include "../../scenes/scene_file.h"
#include "../output_files.h"
#include "shared.h"

#include <fmt/format.h>

namespace plumbline {

int runReference(const ReferenceArguments& arguments) {
    Progress progress;
    progress.step("reading the scene");
    const Scene scene = readScene(findScene(arguments.scene), arguments.sceneChanges);
    printWarnings(scene.warnings);
    ReferenceOptions options = referenceOptions(arguments);
    options.base = parseBase(arguments.base, false) == BaseChoice::Proxy ? Base::Proxy : Base::Limit;
    const std::filesystem::path file = arguments.output.value_or(
        std::filesystem::path("plumbline-out") / safeFileName(scene.name) / "frames" / "reference.exr");
    requireWritableFile(file, findScene(arguments.scene));

    progress.step("tessellating");
    ReferenceScene reference(scene, options);
    printWarnings(reference.stats().warnings);
    progress.step("tracing");
    const Frame frame = reference.render();
    progress.step("writing");
    writeFrame(frame, file);

    const ReferenceStats& stats = reference.stats();
    progress.say(certificateLine(summaryOf(stats, frame).certificate));
    fmt::print("{}\n{} micro-triangles; tessellate {:.0f} ms, build {:.0f} ms, trace {:.0f} ms, certify "
               "{:.0f} ms; peak "
               "{:.0f} MB\n",
               file.string(), stats.microTriangles, stats.tessellateMs, stats.buildMs, stats.traceMs,
               stats.certifyMs, static_cast<double>(peakBytes()) / 1e6);
    for (const ReferenceStats::Object& object : stats.objects)
        if (object.rate < object.wantedRate)
            fmt::print("{}: {} segments per control edge of the {} wanted\n", object.name, object.rate,
                       object.wantedRate);
    return kExitDone;
}

} // namespace plumbline
