#include "reference/reference.h"
#include "validate/cli/command_line.h"

#include <fmt/format.h>

namespace plumbline {

void addThreads(CLI::App& command, Arguments& arguments) {
    command
        .add_option("--threads", arguments.threads, "Threads of reference, bakes and llvmpipe (default: all)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
}

void addScene(CLI::App& command, std::string& scene, std::vector<std::string>& changes,
              const std::string& help) {
    command.add_option("SCENE", scene, help);
    command
        .add_option("--scene-set", changes,
                    "Read the scene with another value in a field, as camera.width=400; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
}

void addReportOptions(CLI::App& command, ReportArguments& arguments) {
    command.add_flag("--single-file", arguments.singleFile,
                     "Write the report as one file that holds everything");
    command.add_flag("--plain-report", arguments.plain,
                     "Write the report without scripts and plots, every picture as PNG");
}

void addReferenceOptions(CLI::App& command, ReferenceArguments& arguments, const char* bases) {
    command
        .add_option(
            "--base", arguments.base,
            "Surface the reference displaces: the limit surface or the proxy's polygons (default: limit)")
        ->type_name(bases);
    command
        .add_option("--error-px", arguments.errorPx,
                    fmt::format("Aim for the reference's own error, pixels, 99 % of them (default: {})",
                                ReferenceOptions().errorPx))
        ->type_name("E");
    command
        .add_option("--rate", arguments.rate, "Segments per control edge, a power of two (default: chosen)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command
        .add_option("--memory", arguments.memory,
                    "Budget of micro-triangles, as 256M or 2G (default: half of the memory that is free)")
        ->type_name("SIZE");
}

void addRealtimeOptions(CLI::App& command, RealtimeArguments& arguments) {
    command
        .add_option("--technique", arguments.techniques,
                    "SEARCH[@SURFACE][:key=value,…], SEARCH a name or a folder; may be repeated. Default: "
                    "all: every search on flat and quadric, linear_binary on the quadric's variants")
        ->type_name("NAME|DIR")
        ->allow_extra_args(false);
    command.add_option("--set", arguments.settings, "A parameter of all techniques; may be repeated")
        ->type_name("key=value")
        ->allow_extra_args(false);
    command.add_option("--gl", arguments.glBackend, "auto, egl or osmesa")->type_name("BACKEND");
    command.add_option("--device", arguments.glDevice, "EGL device")
        ->check(CLI::Range(0, 1023))
        ->type_name("N");
    command
        .add_option("--time-limit", arguments.timeLimitSeconds,
                    fmt::format("Seconds a technique may compile and draw before it is stopped (default: {})",
                                kDefaultTimeLimitSeconds))
        ->check(CLI::Range(1, kLongestTimeLimitSeconds))
        ->type_name("SECONDS");
}

void addRequire(CLI::App& command, std::vector<std::string>& require) {
    command
        .add_option("--require", require,
                    "What must be reached, as \"silhouette.iou >= 0.99\", else exit code 1; may be repeated")
        ->type_name("METRIC>=X")
        ->allow_extra_args(false);
}

void addExports(CLI::App& command, ReferenceArguments& arguments) {
    command
        .add_option("--export-mesh", arguments.meshFile,
                    "Also write the displaced triangles, for other renderers")
        ->type_name("FILE.ply|obj");
    command.add_option("--export-camera", arguments.cameraFile, "Also write the camera and the lights")
        ->type_name("FILE.json");
}

void addChannelMap(CLI::App& command, CompareArguments& arguments) {
    command
        .add_option("--map", arguments.channelMap,
                    "A channel of TEST is one of ours: Depth.Z=Z, dist=distance (along the ray), "
                    "Normal.Y=-N.Z; may be repeated")
        ->type_name("THEIRS=OURS")
        ->allow_extra_args(false);
}

} // namespace plumbline
