// Usage, and the commands that must work without OpenGL: reference, compare, list.
#include "scenes/frame/frame_exr.h"
#include "tests/end_to_end/program.h"
#include "tests/validate/metrics/painted_frames.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(EndToEnd, UnknownCommandsAndOptions_HaveHint) {
    expectRefusal(run({"valdate"}), 2, "did you mean 'validate'?");
    expectRefusal(run({"xyzzy"}), 2, "there is no command 'xyzzy'; expected validate, reference");
    expectRefusal(run({"reference", "x", "--memry", "1G"}), 2, "did you mean '--memory'?");
    expectRefusal(run({"reference"}), 2, "SCENE");
    expectRefusal(run({"compare", "only_one.exr"}), 2, "TEST");
    expectRefusal(run({"list", "scense"}), 2, "did you mean 'scenes'?");
    expectRefusal(run({"--frobnicate"}), 2, "--frobnicate");
    expectRefusal(run({"study"}), 2, "study: a subcommand is missing; expected run or report");
    expectRefusal(run({"study", "rum"}), 2,
                  "study: there is no 'rum'; expected run or report; did you mean 'run'?");
    expectRefusal(run({"study", "run"}), 2,
                  "study run: STUDY is required; 'plumbline study run --help' lists the choices");
    expectRefusal(run({"study", "run", "quadric", "--jbos", "3"}), 2,
                  "study run: '--jbos' was not expected; did you mean '--jobs'?");
    expectRefusal(run({"list", "scenes", "extra"}), 2, "'extra' was not expected");
}

TEST_F(EndToEnd, OptionsOutOfRange_AreRefused) {
    const std::string scene = writeSmallScene();
    for (const char* bad : {"0", "-1", "1e9", "two", ""})
        expectRefusal(run({"reference", scene, "--threads", bad}), 2, "--threads");
    for (const char* bad : {"3", "2048", "-2"})
        expectRefusal(run({"reference", scene, "--rate", bad}), 2, "--rate");
    for (const char* bad : {"", "M", "1T", "-5M", "0", "99999999999G", "1 M", "1.5G"})
        expectRefusal(run({"reference", scene, "--memory", bad}), 2, "--memory");
    for (const char* bad : {"cage", "both", "", "Limit"})
        expectRefusal(run({"reference", scene, "--base", bad}), 2, "--base");
    expectRefusal(run({"reference", scene, "--base", "prxy"}), 2, "did you mean 'proxy'?");
    for (const char* bad : {"0", "-1", "nan", "inf", "1001", "9e-7", "0.05px", "0,05", ""})
        expectRefusal(run({"reference", scene, "--error-px", bad}), 2, "--error-px");
    for (const char* bad : {"0", "-1", "86401", "1.5", "forever", ""})
        for (const char* command : {"validate", "realtime"})
            expectRefusal(run({command, scene, "--technique", "linear_binary", "--time-limit", bad}), 2,
                          "--time-limit");
    EXPECT_EQ(filesBelow(folder_), std::vector<std::string>{"small.toml"});
}

TEST_F(EndToEnd, NoArguments_ShowCommands) {
    const Outcome bare = run({});
    EXPECT_EQ(bare.exitCode, 2);
    EXPECT_THAT(bare.err, HasSubstr("validate"));
    EXPECT_THAT(bare.out, IsEmpty());
}

TEST_F(EndToEnd, HelpAndVersion_GoToStdout) {
    EXPECT_THAT(run({"--version"}).out, HasSubstr("plumbline "));
    const Outcome help = run({"validate", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.out, HasSubstr("--technique"));
}

TEST_F(EndToEnd, List_PrintsScenesAndMetrics) {
    const Outcome scenes = run({"list", "scenes"});
    EXPECT_EQ(scenes.exitCode, 0);
    EXPECT_THAT(scenes.out, HasSubstr("stone_torus"));
    EXPECT_THAT(run({"list", "metrics"}).out, HasSubstr("silhouette.iou"));
    EXPECT_THAT(run({"list", "techniques"}).out, HasSubstr("\nlinear_binary: "));
    EXPECT_THAT(run({"list", "surfaces"}).out, HasSubstr("\nquadric: "));
}

TEST_F(EndToEnd, ReferenceOnAnyThreadCount_GivesEqualBytes) {
    const std::string scene = writeSmallScene();
    const std::vector<std::vector<std::string>> ways{{"-o", "a.exr"},
                                                     {"-o", "b.exr"},
                                                     {"-o", "one.exr", "--threads", "1"},
                                                     {"-o", "two.exr", "--threads", "2"}};
    for (std::vector<std::string> way : ways) {
        way.insert(way.begin(), {"reference", scene, "--rate", "16"});
        const Outcome made = run(way);
        ASSERT_EQ(made.exitCode, 0) << made.err;
        expectOnlyTheCertificate(made.err); // no progress, because stderr is no terminal
    }
    const std::string bytes = readFile(folder_ / "a.exr");
    EXPECT_GT(bytes.size(), 1000u);
    EXPECT_TRUE(bytes == readFile(folder_ / "b.exr"));
    EXPECT_TRUE(bytes == readFile(folder_ / "one.exr"));
    EXPECT_TRUE(bytes == readFile(folder_ / "two.exr"));
}

TEST_F(EndToEnd, ReferenceOptions_TakeEffect) {
    const std::string scene = writeSmallScene();
    for (const char* base : {"limit", "proxy"})
        for (const char* aim : {"1e-6", "0.5", "1000"}) {
            const Outcome made =
                run({"reference", scene, "--rate", "8", "--base", base, "--error-px", aim, "-o", "a.exr"});
            EXPECT_EQ(made.exitCode, 0) << made.err;
            expectOnlyTheCertificate(made.err);
        }
}

TEST_F(EndToEnd, TooLittleMemoryForRate_IsMachineError) {
    const std::string scene = writeSmallScene();
    expectRefusal(run({"reference", scene, "--rate", "1024", "--memory", "1M", "-o", "a.exr"}), 3,
                  "--memory");
    EXPECT_EQ(filesBelow(folder_), std::vector<std::string>{"small.toml"});
}

TEST_F(EndToEnd, FrameWithItself_HasNoError) {
    const std::string scene = writeSmallScene();
    ASSERT_EQ(run({"reference", scene, "--rate", "16", "-o", "a.exr"}).exitCode, 0);
    const Outcome compared = run({"compare", "a.exr", "a.exr", "--json"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    const json technique = json::parse(compared.out).at("techniques").at(0);
    EXPECT_EQ(technique["pooled_objects"], json::array({"torus"})); // the floor has no relief
    EXPECT_EQ(technique["silhouette"]["iou"], 1.0);
    EXPECT_GT(technique["silhouette"]["reference_px"], 1000);
    for (const char* key : {"bias", "mae", "rmse", "max", "rmse_relief", "badpix_1pct"})
        EXPECT_EQ(technique["depth"].at(key), 0.0) << key;
    EXPECT_EQ(technique["shadow"]["sun"]["agreement"], 1.0);
    EXPECT_EQ(technique["shadow"]["sun"]["ber"], 0.0);
    EXPECT_EQ(technique["normal"]["p95_degrees"], 0.0);
    EXPECT_EQ(technique["st"]["p95_texels"], 0.0);
    EXPECT_EQ(technique["objects"].size(), 2u);
}

// A plane of depth Z = 2 + x/8 over columns 2 … 9 of ten rows (80 pixels), its shadow in columns 2 … 4, moved
// right by one:
//   silhouette: columns 3 … 9 shared (70), column 2 missing (10), column 10 extra (10): IoU 70/90
//   depth: the test shows at x what the reference shows at x - 1, so e = -1/8 everywhere: bias -1/8, MAE =
//          RMSE = p50 = p99 = max = 1/8; with a relief depth of 1/2 that is 1/4: above 1 % and 5 %, not above
//          25 %
//   shadow: reference dark in 3 4 of the shared columns, test in 3 4 5: TP 20, FP 10, FN 0, TN 40:
//          agreement 60/70, IoU 20/30, F1 40/50, BER = (10/50 + 0)/2 = 0.1
TEST_F(EndToEnd, FrameShiftedByOne_HasKnownIou) {
    Frame reference = emptyFrame(12, 12);
    for (int x = 2; x < 10; ++x) {
        paintRectangle(reference, x, 1, x + 1, 11, 1, 2.0f + static_cast<float>(x) / 8.0f);
        for (int y = 1; y < 11; ++y)
            set(reference, "shadow.sun", x, y, x < 5 ? 1.0f : 0.0f);
    }
    reference.metadata = {{"object.1.name", "plane"}, {"object.1.relief_depth", "0.5"}};
    writeFrame(reference, folder_ / "reference.exr");
    writeFrame(shiftedRight(reference), folder_ / "test.exr");

    const Outcome compared = run({"compare", "reference.exr", "test.exr", "-o", "out"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    const json technique = json::parse(readFile(folder_ / "out/results.json")).at("techniques").at(0);
    const json &silhouette = technique["silhouette"], &depth = technique["depth"],
               &shadow = technique["shadow"]["sun"];
    EXPECT_DOUBLE_EQ(silhouette["iou"], 70.0 / 90.0);
    EXPECT_EQ(silhouette["missing_px"], 10);
    EXPECT_EQ(silhouette["extra_px"], 10);
    EXPECT_EQ(depth["domain_px"], 70);
    EXPECT_EQ(depth["bias"], -0.125);
    for (const char* key : {"mae", "rmse", "p50", "p95", "p99", "max"})
        EXPECT_EQ(depth[key], 0.125) << key;
    EXPECT_EQ(depth["rmse_relief"], 0.25);
    EXPECT_EQ(depth["badpix_5pct"], 1.0);
    EXPECT_EQ(depth["badpix_25pct"], 0.0);
    EXPECT_DOUBLE_EQ(shadow["agreement"], 60.0 / 70.0);
    EXPECT_DOUBLE_EQ(shadow["iou"], 20.0 / 30.0);
    EXPECT_DOUBLE_EQ(shadow["f1"], 0.8);
    EXPECT_DOUBLE_EQ(shadow["ber"], 0.1);
    EXPECT_EQ(shadow["false_shadow_px"], 10);
    EXPECT_EQ(shadow["false_lit_px"], 0);
    EXPECT_THAT(filesBelow(folder_ / "out"),
                ::testing::IsSupersetOf(
                    {"results.json", "results.csv", "report/index.html", "report/reference.png"}));
}

// 9 of 12 pixels of a row: IoU 0.75.
TEST_F(EndToEnd, CompareRequirement_DecidesExitCode) {
    Frame reference = emptyFrame(20, 3), test = reference;
    paintRectangle(reference, 2, 1, 14, 2);
    paintRectangle(test, 2, 1, 11, 2);
    writeFrame(reference, folder_ / "reference.exr");
    writeFrame(test, folder_ / "test.exr");
    const auto compare = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"compare", "reference.exr", "test.exr"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    };
    const Outcome reached = compare({"--require", "silhouette.iou >= 0.75", "--require", "depth.max<=0"});
    EXPECT_EQ(reached.exitCode, 0) << reached.err;
    EXPECT_THAT(reached.out, HasSubstr("2/2"));
    const Outcome missed =
        compare({"--require", "silhouette.iou > 0.75", "--require", "depth.max<=0", "--json"});
    EXPECT_EQ(missed.exitCode, 1);
    EXPECT_EQ(missed.err, "test: silhouette.iou is 0.75; required silhouette.iou > 0.75\n");
    const json requirements = json::parse(missed.out).at("techniques").at(0).at("requirements");
    EXPECT_EQ(requirements.at(0).at("passed"), false);
    EXPECT_EQ(requirements.at(1).at("passed"), true);
    const Outcome absent = compare({"--require", "shadow.sun.ber < 1"});
    EXPECT_EQ(absent.exitCode, 1);
    EXPECT_THAT(absent.err, HasSubstr("shadow.sun.ber is absent (no pixel of the domain is in shadow"));
    expectRefusal(compare({"--require", "silhouette.oiu >= 1"}), 2, "did you mean 'silhouette.iou'");
    expectRefusal(compare({"--require", "shadow.sum.iou >= 1"}), 2, "did you mean 'sun'");
}

TEST_F(EndToEnd, CompareOfDifferentHeaders_ListsDifferences) {
    const std::string view = "perspective position 0 0 3 target 0 0 0 up 0 1 0 fov_y_degrees 40 size 8 6";
    Frame reference = emptyFrame(8, 6), test = emptyFrame(8, 6);
    const auto compared = [&] {
        writeFrame(reference, folder_ / "reference.exr");
        writeFrame(test, folder_ / "test.exr");
        return run({"compare", "reference.exr", "test.exr"});
    };
    reference.metadata = test.metadata = {{"camera", view}, {"scene_hash", "one"}};
    EXPECT_THAT(compared().out, Not(HasSubstr("headers of the two frames")));
    test.metadata["camera"] = // the same camera
        "perspective position 0.0 0.0 3.0 target 0 0 0 up 0 1 0 fov_y_degrees 40.0 size 8 6";
    EXPECT_THAT(compared().out, Not(HasSubstr("headers of the two frames")));
    test.metadata = {{"camera", "perspective position 0 0 4" + view.substr(view.find(" target"))},
                     {"scene_hash", "other"}};
    const Outcome different = compared();
    EXPECT_EQ(different.exitCode, 0) << different.err;
    EXPECT_THAT(different.out, HasSubstr("name different cameras: the reference's is used for both"));
    EXPECT_THAT(different.out, HasSubstr("name different scenes"));
    test.metadata = {{"camera", "Cam01"}, {"light.sun", "bright"}};
    const Outcome unreadable = compared();
    EXPECT_THAT(unreadable.out,
                HasSubstr("note: test.exr: the header field 'camera' doesn't have plumbline's format"));
    EXPECT_THAT(unreadable.out, HasSubstr("note: test.exr: the header field 'light.sun' doesn't"));
    reference.metadata["light.sun"] = "bright";
    reference.metadata["program"] = "plumbline 0.1.0";
    expectRefusal(compared(), 2, "reference.exr: header field 'light.sun': 'bright' can't be read");
}

TEST_F(EndToEnd, CompareWithoutFolder_WritesNoReport) {
    writeFrame(emptyFrame(8, 6), folder_ / "a.exr");
    for (const char* option : {"--single-file", "--plain-report"})
        expectRefusal(run({"compare", "a.exr", "a.exr", option}), 2, "none is written; expected -o DIR");
}

// Columns 2 … 5 of four rows are 16 pixels. The test lacks column 2: 12/16. Column 2 of row 1 is uncertain,
// so the IoU is at most 12/15. A pixel outside is also uncertain, so it is at least 12/17.
TEST_F(EndToEnd, UncertainReference_GivesIntervals) {
    Frame reference = emptyFrame(8, 6), test = emptyFrame(8, 6);
    paintRectangle(reference, 2, 1, 6, 5);
    paintRectangle(test, 3, 1, 6, 5);
    addUncertainty(reference);
    set(reference, "uncertain", 2, 1, 1);
    set(reference, "uncertain", 0, 0, 1);
    set(reference, "uncertain.shadow.sun", 4, 1, 1);
    reference.metadata = {
        {"base", "proxy"}, {"certificate.error_px_p99", "0.031"}, {"certificate.error_limit", "--rate 8"}};
    writeFrame(reference, folder_ / "reference.exr");
    writeFrame(test, folder_ / "test.exr");

    const Outcome compared = run({"compare", "reference.exr", "test.exr", "--json"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    const json results = json::parse(compared.out), technique = results["techniques"][0];
    EXPECT_EQ(results["base"], "proxy");
    EXPECT_EQ(results["reference"]["error_px_p99"], 0.031);
    EXPECT_EQ(results["reference"]["error_limit"], "--rate 8");
    EXPECT_THAT(results["reference"]["absent"]["error_px_max"].get<std::string>(),
                HasSubstr("no header field certificate.error_px_max"));
    EXPECT_EQ(results["reference"]["uncertain_pixels"], 2);
    EXPECT_EQ(results["reference"]["uncertain_shadow_pixels"]["sun"], 1);
    EXPECT_EQ(technique["silhouette"]["iou"], 12.0 / 16.0);
    EXPECT_EQ(technique["silhouette"]["iou_low"], 12.0 / 17.0);
    EXPECT_EQ(technique["silhouette"]["iou_high"], 12.0 / 15.0);
    EXPECT_EQ(technique["shadow"]["sun"]["agreement_low"], 11.0 / 12.0);
    EXPECT_EQ(technique["shadow"]["sun"]["uncertain_px"], 1);

    reference.metadata["certificate.error_px_p99"] = "tiny";
    writeFrame(reference, folder_ / "reference.exr");
    expectRefusal(run({"compare", "reference.exr", "test.exr"}), 2,
                  "reference.exr: header field 'certificate.error_px_p99'");
}

TEST_F(EndToEnd, ImportedCoverageAndDepth_AreCompared) {
    Frame frame(2, 1);
    frame.add("A")[0] = 1;
    frame.add("Z")[0] = 2;
    writeFrame(frame, folder_ / "imported.exr");
    const Outcome compared = run({"compare", "imported.exr", "imported.exr"});
    EXPECT_EQ(compared.exitCode, 0) << compared.err;
    EXPECT_THAT(compared.out, HasSubstr("note: neither frame has a channel id"));
    EXPECT_THAT(compared.out, HasSubstr("no normal figures"));
}

} // namespace
} // namespace plumbline
