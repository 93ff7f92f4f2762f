// The command line: arguments to structs, errors to one line and an exit code. What is done is in commands/.
#include "../realtime/inputs/bake.h"
#include "../reference/reference.h"
#include "../scenes/error.h"
#include "../scenes/scene_metadata.h"
#include "commands/commands.h"
#include "usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>

namespace plumbline {
namespace {

struct Arguments {
    ReferenceArguments reference;
    RealtimeArguments realtime;
    ValidateArguments validate;
    CompareArguments compare;
    BakeArguments bake;
    StudyArguments study;
    NewArguments fresh;
    HistoryArguments history;
    std::string listed;
    int threads = 0; // 0: as many as the machine has
    int parent = 0;  // of a drawing process
};

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

/// `bases`: what --base may be.
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

void addBake(CLI::App& app, Arguments& arguments, std::function<int()>& run) {
    BakeArguments& bake = arguments.bake;
    CLI::App* command = app.add_subcommand("bake", "Work out a map that techniques look up; kept by content");
    command->add_option("MAP", bake.map, "A picture, or SCENE#NAME: a height map of a scene")->required();
    command->add_option("--kind", bake.kind, "What to work out; 'plumbline list bakes' says what each holds")
        ->required()
        ->type_name("K");
    command->add_option("-o", bake.output, "Also a picture of it")->type_name("FILE.exr");
    command->add_option("--stores", bake.stores, "What the picture's values are")->type_name("depth|height");
    command->add_option("--wrap", bake.wrap, "Along s and t, repeat or clamp each (default: repeat,repeat)")
        ->type_name("S,T");
    command
        ->add_option("--depth", bake.depth, "World units of relief depth 1, for kinds that ask for a scale")
        ->type_name("D");
    command->add_option("--tile-size", bake.tileSize, "World units of one map width and height, likewise")
        ->type_name("SX,SY");
    command
        ->add_option("--slices", bake.slices,
                     fmt::format("Of a distance field (default: {})", BakeRequest().slices))
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->add_flag("--check", bake.check,
                      "Of a cone map: step random rays by it and count those that leap over the relief");
    command
        ->add_option("--rays", bake.rays,
                     fmt::format("How many, with --check (default: {})", kDefaultCheckRays))
        ->check(CLI::Range(uint64_t(1), uint64_t(1) << 40))
        ->type_name("N");
    addThreads(*command, arguments);
    command->callback([&] { run = [&] { return runBake(arguments.bake); }; });
}

void addStudy(CLI::App& app, Arguments& arguments, std::function<int()>& run) {
    StudyArguments& study = arguments.study;
    CLI::App* command =
        app.add_subcommand("study", "Sweep scenes, their values and techniques; tables and plots of it");
    command->require_subcommand(1);
    const auto addCommon = [&](CLI::App& sub) {
        sub.add_option("STUDY", study.study, "A study file or a name of validate/studies/")->required();
        sub.add_option("-o", study.output, "Folder of its results (default: plumbline-out/study-NAME)")
            ->type_name("DIR");
        sub.add_flag("--yes", study.yes, "Also with more than 2000 cases");
    };
    CLI::App* sweep = command->add_subcommand("run", "Work out every case that isn't known yet");
    addCommon(*sweep);
    sweep->add_option("--jobs", study.jobs, "Cases at a time (default: as many as there are cores)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    sweep->add_option("--gl", study.glBackend, "auto, egl or osmesa")->type_name("BACKEND");
    sweep->add_option("--device", study.glDevice, "EGL device")->check(CLI::Range(0, 1023))->type_name("N");
    addThreads(*sweep, arguments);
    sweep->callback([&] {
        arguments.study.threads = arguments.threads;
        run = [&] { return runStudy(arguments.study); };
    });
    CLI::App* report = command->add_subcommand("report", "Tables and plots of the cases worked out so far");
    addCommon(*report);
    report->callback([&] { run = [&] { return runStudyReport(arguments.study); }; });
}

void addNew(CLI::App& app, Arguments& arguments, std::function<int()>& run) {
    NewArguments& fresh = arguments.fresh;
    CLI::App* command = app.add_subcommand("new", "Write a first scene file for a mesh and a height map");
    command->add_option("--mesh", fresh.mesh, "A mesh with texture coordinates")
        ->required()
        ->type_name("M.obj");
    command->add_option("--height", fresh.height, "The relief, a grey picture")
        ->required()
        ->type_name("H.png");
    command->add_option("-o", fresh.output, "The scene file")->required()->type_name("SCENE.toml");
    command
        ->add_option("--depth", fresh.depth,
                     "World units from the relief's top to its bottom (default: chosen)")
        ->type_name("D");
    command->add_option("--tile", fresh.tile, "Repeats of the map along u and v (default: chosen)")
        ->type_name("S,T");
    command->add_option("--scheme", fresh.scheme, "What the mesh is a cage of (default: chosen)")
        ->type_name("catmull-clark|loop|none");
    command->add_option("--stores", fresh.stores, "What the picture's values are (default: height)")
        ->type_name("height|depth");
    command->add_option("--wrap", fresh.wrap, "Along s and t, repeat or clamp each (default: repeat,repeat)")
        ->type_name("S,T");
    command->add_flag("--force", fresh.force, "Replace a scene file that exists");
    command->callback([&] { run = [&] { return runNew(arguments.fresh); }; });
}

void addHistory(CLI::App& app, Arguments& arguments, std::function<int()>& run) {
    HistoryArguments& history = arguments.history;
    CLI::App* command = app.add_subcommand(
        "history", "Keep results of a shader under test, and say what became worse (exit 1)");
    command->add_option("FILE", history.file, "The history, a line a run; made if it isn't there")
        ->required();
    command->add_option("RESULTS", history.results,
                        "results.json files to add, oldest first; none: only look");
    command
        ->add_option("--label", history.label, "Of the results, as a commit (default: the program's version)")
        ->type_name("TEXT");
    command
        ->add_option(
            "--tolerance", history.tolerances,
            "How much worse a figure may become, as silhouette.iou=0.001, depth.rmse=2% or all=1%; may be "
            "repeated. Default: not at all, but within the interval of a figure that has one; cost, at will")
        ->type_name("FIGURE=AMOUNT")
        ->allow_extra_args(false);
    command->add_flag("--dry-run", history.dryRun, "Compare, and leave FILE as it is");
    command->callback([&] { run = [&] { return runHistory(arguments.history); }; });
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

/// Adds the commands to `app`; the one chosen stores what is to be run in `run`.
void addCommands(CLI::App& app, Arguments& arguments, std::function<int()>& run) {
    CLI::App* validate =
        app.add_subcommand("validate", "Hold techniques against the displaced truth: metrics and report");
    addScene(*validate, arguments.validate.reference.scene, arguments.validate.reference.sceneChanges,
             fmt::format("A scene file or a name of the library (default: {})", kDefaultScene));
    validate
        ->add_option("-o", arguments.validate.output, "Folder of the results (default: plumbline-out/SCENE)")
        ->type_name("DIR");
    addReportOptions(*validate, arguments.validate.report);
    addReferenceOptions(*validate, arguments.validate.reference, "limit|proxy|both");
    addRealtimeOptions(*validate, arguments.validate.realtime);
    addRequire(*validate, arguments.validate.require);
    addThreads(*validate, arguments);
    validate->callback([&] {
        arguments.validate.realtime.threads = arguments.threads;
        run = [&] { return runValidate(arguments.validate); };
    });

    CLI::App* reference = app.add_subcommand("reference", "Write the exact frame of a scene");
    addScene(*reference, arguments.reference.scene, arguments.reference.sceneChanges,
             "A scene file or a name of the library");
    reference->get_option("SCENE")->required();
    reference->add_option("-o", arguments.reference.output, "The frame's file")->type_name("FILE.exr");
    addReferenceOptions(*reference, arguments.reference, "limit|proxy");
    addExports(*reference, arguments.reference);
    addThreads(*reference, arguments);
    reference->callback([&] { run = [&] { return runReference(arguments.reference); }; });

    CLI::App* realtime = app.add_subcommand("realtime", "Write the frame of one technique");
    addScene(*realtime, arguments.realtime.scene, arguments.realtime.sceneChanges,
             "A scene file or a name of the library");
    realtime->get_option("SCENE")->required();
    realtime->add_option("-o", arguments.realtime.output, "The frame's file")->type_name("FILE.exr");
    addRealtimeOptions(*realtime, arguments.realtime);
    addThreads(*realtime, arguments);
    realtime->callback([&] {
        arguments.realtime.threads = arguments.threads;
        run = [&] { return runRealtime(arguments.realtime); };
    });

    CLI::App* compare = app.add_subcommand("compare", "Hold one frame against another, of any renderer");
    compare->add_option("REFERENCE", arguments.compare.reference, "The true frame, EXR")->required();
    compare->add_option("TEST", arguments.compare.test, "The frame to judge, EXR")->required();
    compare->add_option("-o", arguments.compare.output, "Folder for results and report")->type_name("DIR");
    compare->add_flag("--json", arguments.compare.json, "Print results.json instead of the table");
    addReportOptions(*compare, arguments.compare.report);
    addChannelMap(*compare, arguments.compare);
    addRequire(*compare, arguments.compare.require);
    compare->callback([&] { run = [&] { return runCompare(arguments.compare); }; });

    addNew(app, arguments, run);
    addHistory(app, arguments, run);
    addBake(app, arguments, run);
    addStudy(app, arguments, run);

    CLI::App* list =
        app.add_subcommand("list", "List scenes, techniques, surfaces, metrics or kinds of baked maps");
    list->add_option("WHAT", arguments.listed, "scenes, techniques, surfaces, metrics or bakes")->required();
    list->callback([&] { run = [&] { return runList(arguments.listed); }; });

    app.add_subcommand("doctor", "Say what this machine can do")->callback([&] {
        run = [] { return runDoctor(); };
    });

    CLI::App* worker = app.add_subcommand(kDrawWorkerCommand, "")->group(""); // hidden
    worker->add_option("PARENT", arguments.parent, "");
    worker->add_option("--threads", arguments.threads, "");
    worker->callback([&] { run = [&] { return runDrawWorker(arguments.parent); }; });
    CLI::App* studyCase = app.add_subcommand(kStudyCaseCommand, "")->group(""); // hidden
    studyCase->add_option("PARENT", arguments.parent, "");
    studyCase->add_option("--threads", arguments.threads, "");
    studyCase->callback([&] { run = [&] { return runStudyCase(arguments.parent); }; });
}

void limitThreads(int threads, std::unique_ptr<tbb::global_control>& control) {
    if (threads == 0) return;
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<size_t>(threads));
    ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1); // llvmpipe reads it when GL starts
}

int runProgram(int argc, char** argv) {
    CLI::App app("Holds fast approximations of displaced surfaces against a true one.", "plumbline");
    app.set_version_flag("--version", programName());
    app.require_subcommand(1);
    Arguments arguments;
    std::function<int()> run;
    addCommands(app, arguments, run);
    if (argc < 2) {
        std::fputs(app.help().c_str(), stderr);
        return kExitBadInput;
    }
    requireCommand(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error); // --help and --version
        throw usageError(app, error);
    }
    std::unique_ptr<tbb::global_control> control;
    limitThreads(arguments.threads, control);
    return run();
}

int fail(int exitCode, std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' '); // one error, one line
    std::fputs((message + "\n").c_str(), stderr);
    return exitCode;
}

} // namespace
} // namespace plumbline

int main(int argc, char** argv) {
    using namespace plumbline;
    try {
        return runProgram(argc, argv);
    } catch (const InputError& error) {
        return fail(kExitBadInput, error.what());
    } catch (const MachineError& error) {
        return fail(kExitMachine, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kExitMachine,
                    "plumbline: this machine hasn't the memory for that; expected a smaller scene or frame");
    } catch (const std::exception& error) {
        return fail(kExitInternal, std::string("internal error: ") + error.what());
    }
}
