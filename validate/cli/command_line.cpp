#include "validate/cli/command_line.h"

#include "realtime/bake/bake.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

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

} // namespace

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

} // namespace plumbline
