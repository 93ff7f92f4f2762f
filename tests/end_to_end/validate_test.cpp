// plumbline validate with OpenGL: reference, techniques, metrics, report.
#include "scenes/core/data_folder.h"
#include "tests/end_to_end/program.h"
#include "tests/read_frame.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using namespace test;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

class Validate : public EndToEnd {
  protected:
    Outcome validate(const std::string& output, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"validate", "small.toml", "--rate", "16", "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    json resultsOf(const std::string& output) const {
        return json::parse(readFile(folder_ / output / "results.json"));
    }
    /// A copy of a technique of the program, to be modified.
    fs::path copyTechnique(const std::string& name) const {
        fs::copy(dataFolder() / "realtime" / "techniques" / "linear_binary", folder_ / name,
                 fs::copy_options::recursive);
        fs::rename(folder_ / name / "linear_binary.glsl", folder_ / name / (name + ".glsl"));
        return folder_ / name;
    }
    /// Expects that all frames of two outputs are equal, byte for byte.
    void expectEqualFrames(const std::string& first, const std::string& second) const {
        const auto files = filesBelow(folder_ / first / "frames");
        ASSERT_GE(files.size(), 2u);
        ASSERT_EQ(files, filesBelow(folder_ / second / "frames"));
        for (const std::string& file : files)
            EXPECT_TRUE(readFile(folder_ / first / "frames" / file) ==
                        readFile(folder_ / second / "frames" / file))
                << file;
    }
};

/// Removes timings and memory, which are measurements; everything else must be equal.
json withoutMeasurements(json results) {
    for (const char* key : {"tessellate_ms", "build_ms", "trace_ms", "peak_bytes"})
        results["reference"].erase(key);
    for (json& technique : results["techniques"]) {
        technique["cost"].erase("ms_median");
        technique["cost"].erase("ms_runs");
    }
    return results;
}
// A mistake in the scene's [require] is reported with its line before anything is drawn.
TEST_F(Validate, BadSceneRequirement_IsRefusedFirst) {
    for (const auto& [line, part] :
         {std::pair("\"silhouette.oiu\" = \">= 1\"", "did you mean 'silhouette.iou'"),
          {"\"silhouette.iou@tours\" = \">= 1\"", "did you mean 'torus'"},
          {"\"silhouette.iou\" = \"1\"", "contains no comparison"}}) {
        writeFile(folder_ / "small.toml", std::string(kSmallScene) + "\n[require]\n" + line + "\n");
        const Outcome refused = validate("out");
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_THAT(refused.err, HasSubstr(part));
        EXPECT_THAT(refused.err, HasSubstr("small.toml:"));
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
}

// No IoU is above 1, and each technique covers a part of the torus.
TEST_F(Validate, MissedRequirement_ExitsWith1) {
    writeFile(folder_ / "small.toml",
              std::string(kSmallScene) + "\n[require]\n\"silhouette.iou\" = [\"> 0\", \"> 1\"]\n");
    const Outcome missed =
        validate("out", {"--technique", "micro_triangles", "--technique", "linear_binary"});
    EXPECT_EQ(missed.exitCode, 1) << missed.err;
    EXPECT_THAT(missed.out, HasSubstr("1/2 FAILED"));
    EXPECT_THAT(missed.err, HasSubstr("required silhouette.iou > 1"));
    const json techniques = resultsOf("out").at("techniques");
    EXPECT_FALSE(techniques.at(0).contains("requirements")); // requirements aren't evaluated for controls
    const json requirements = techniques.at(1).at("requirements");
    EXPECT_EQ(requirements.at(0).at("passed"), true);
    EXPECT_EQ(requirements.at(1).at("passed"), false);
    // A failed technique reaches no requirement, but its exit code takes precedence.
    const Outcome failed = validate("out", {"--technique", "linear_binary:linear_steps=0"});
    EXPECT_EQ(failed.exitCode, 2) << failed.err;
}

TEST_F(Validate, SceneSet_EqualsEditedScene) {
    // Also in the drawing process; the frames differ in their metadata only.
    const std::string text = readFile(writeSmallScene());
    ASSERT_EQ(validate("changed", {"--technique", "linear", "--scene-set", "camera.width=64", "--scene-set",
                                   "object.torus.relief.depth=0.05"})
                  .exitCode,
              0);
    writeFile(folder_ / "small.toml", withLine(text, "width = 96", "width = 64"));
    ASSERT_EQ(validate("narrow", {"--technique", "linear", "--scene-set", "object.torus.relief.depth=0.05"})
                  .exitCode,
              0);
    const json changed = resultsOf("changed"), narrow = resultsOf("narrow");
    EXPECT_EQ(changed["scene"]["changes"], json({"camera.width=64", "object.torus.relief.depth=0.05"}));
    EXPECT_EQ(changed["scene"]["width"], 64);
    EXPECT_EQ(changed["scene"]["hash"], narrow["scene"]["hash"]);
    EXPECT_EQ(withoutMeasurements(changed)["techniques"], withoutMeasurements(narrow)["techniques"]);
    EXPECT_THAT(readFile(folder_ / "changed/report/index.html"), HasSubstr("changed: camera.width=64"));
}

TEST_F(Validate, AllTechniques_HaveResults) {
    writeSmallScene();
    const Outcome made = validate("out");
    ASSERT_EQ(made.exitCode, 0) << made.err;
    expectOnlyTheCertificate(made.err);
    EXPECT_THAT(made.out, HasSubstr("linear_binary@quadric"));
    EXPECT_THAT(filesBelow(folder_ / "out"),
                IsSupersetOf({"results.json", "results.csv", "report/index.html", "report/reference.png",
                              "frames/reference.exr", "frames/micro_triangles.exr",
                              "frames/linear_binary-on-quadric.exr"}));
    for (const std::string& file : filesBelow(folder_ / "out"))
        EXPECT_THAT(file, Not(HasSubstr("tmp")));

    const json results = resultsOf("out");
    EXPECT_EQ(results["techniques"][0]["name"], "micro_triangles"); // the control is first
    EXPECT_GT(results["reference"]["micro_triangles"], 0);
    for (const json& technique : results["techniques"]) {
        EXPECT_TRUE(technique["error"].is_null());
        EXPECT_GT(technique["silhouette"]["iou"], 0.5)
            << technique["name"]; // all show the torus in its place
        EXPECT_GT(technique["cost"]["ms_median"], 0.0);
    }
}

/// The control draws micro-triangles, while the reference's depths are those of the surface itself. Along a
/// ray they differ by the certificate's error divided by the sine of the angle between ray and surface. Half
/// of the pixels have an angle above 30 degrees, 99 % one above 3.
void expectDepthWithinCertificate(const json& results) {
    const json depth = results["techniques"][0]["depth"], reference = results["reference"];
    EXPECT_LE(depth["p50"], 2 * reference["error_world_p50"].get<double>());
    EXPECT_LE(depth["p99"], 20 * reference["error_world_p99"].get<double>());
}

// The control draws the triangles that the reference traces. Only pixels whose center lies within the
// rasterizer's sub-pixel grid of an edge may differ: the aim is an IoU of 0.9999 and a depth p99 of 1e-3 of
// the relief.
TEST_F(Validate, Control_AgreesWithReference) {
    writeFile(folder_ / "small.toml",
              withLine(withLine(kSmallScene, "width = 96", "width = 400"), "height = 72", "height = 300"));
    ASSERT_EQ(validate("out", {"--technique", "micro_triangles"}).exitCode, 0);
    const json technique = resultsOf("out")["techniques"][0];
    EXPECT_GE(technique["silhouette"]["iou"], 0.9999);
    expectDepthWithinCertificate(resultsOf("out"));
    EXPECT_GT(technique["depth"]["domain_px"], 20000);
}

TEST_F(Validate, AnyThreadCount_GivesEqualBytes) {
    writeSmallScene();
    ASSERT_EQ(validate("first").exitCode, 0);
    ASSERT_EQ(validate("second").exitCode, 0);
    ASSERT_EQ(validate("one", {"--threads", "1"}).exitCode, 0);
    ASSERT_EQ(validate("two", {"--threads", "2"}).exitCode, 0);
    for (const char* other : {"second", "one", "two"}) {
        expectEqualFrames("first", other);
        EXPECT_EQ(withoutMeasurements(resultsOf("first")), withoutMeasurements(resultsOf(other)));
    }
}

TEST_F(Validate, EglAndOsmesa_GiveEqualBytes) {
    const std::string doctor = run({"doctor"}).out;
    if (doctor.find("ok   GL osmesa") == std::string::npos)
        GTEST_SKIP() << "no OSMesa here (Mesa removed it in 25.1)";
    if (doctor.find("llvmpipe") == std::string::npos)
        GTEST_SKIP() << "no llvmpipe here: hardware may differ from it";
    writeSmallScene();
    const Outcome egl = validate("egl", {"--gl", "egl"}), osmesa = validate("osmesa", {"--gl", "osmesa"});
    ASSERT_EQ(egl.exitCode, 0) << egl.err;
    ASSERT_EQ(osmesa.exitCode, 0) << osmesa.err;
    expectEqualFrames("egl", "osmesa");
    EXPECT_EQ(resultsOf("egl")["techniques"][0]["gl"]["backend"], "egl");
    EXPECT_EQ(resultsOf("osmesa")["techniques"][0]["gl"]["backend"], "osmesa");
}

TEST_F(Validate, Realtime_WritesValidatesFrame) {
    writeSmallScene();
    ASSERT_EQ(validate("out", {"--technique", "linear_binary"}).exitCode, 0);
    const Outcome drawn = run({"realtime", "small.toml", "--technique", "linear_binary", "-o", "alone.exr"});
    ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
    EXPECT_TRUE(readFile(folder_ / "alone.exr") == readFile(folder_ / "out/frames/linear_binary.exr"));
}

TEST_F(Validate, Settings_ReachTechniqueAndName) {
    writeSmallScene();
    ASSERT_EQ(validate("out", {"--technique", "linear_binary:linear_steps=33", "--technique",
                               "linear_binary@quadric", "--set", "binary_steps=3"})
                  .exitCode,
              0);
    const json results = resultsOf("out");
    EXPECT_EQ(results["techniques"][0]["parameters"]["linear_steps"], "33");
    EXPECT_EQ(results["techniques"][0]["parameters"]["binary_steps"], "3");
    EXPECT_THAT(results["techniques"][0]["name"].get<std::string>(), HasSubstr("linear_steps=33"));
    EXPECT_EQ(results["techniques"][1]["parameters"]["binary_steps"], "3");
}

// `compare` with the written frames gives the same figures as the run, for the gap and for a technique
// compared with each base.
TEST_F(Validate, BothBases_HaveResults) {
    const Outcome made = run({"validate", "small_torus", "--base", "both", "--technique", "linear_binary",
                              "--plain-report", "-o", "out"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(std::count(made.err.begin(), made.err.end(), '\n'), 2) << made.err;
    EXPECT_THAT(made.err, HasSubstr("certificate of the reference on the proxy: "));
    EXPECT_THAT(made.out, HasSubstr("(base gap)"));
    EXPECT_THAT(readFile(folder_ / "out/report/index.html"), HasSubstr("base_gap_silhouette.png"));

    const json results = resultsOf("out"), technique = results["techniques"][0];
    EXPECT_EQ(results["base"], "both");
    EXPECT_GT(results["reference_proxy"]["micro_triangles"], 0);
    const auto compared = [&](const std::string& reference, const std::string& test) {
        const Outcome outcome = run({"compare", "out/frames/" + reference, "out/frames/" + test, "--json"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return json::parse(outcome.out)["techniques"][0];
    };
    const json gap = compared("reference.exr", "reference_proxy.exr");
    const json againstLimit = compared("reference.exr", "linear_binary.exr");
    const json againstProxy = compared("reference_proxy.exr", "linear_binary.exr");
    for (const char* group : {"silhouette", "depth", "shadow", "normal", "st"}) {
        EXPECT_EQ(results["base_gap"].at(group), gap.at(group)) << group;
        EXPECT_EQ(technique.at(group), againstLimit.at(group)) << group;
        EXPECT_EQ(technique["against_proxy"].at(group), againstProxy.at(group)) << group;
    }
    EXPECT_FALSE(results["base_gap"].contains("cost"));

    // The outline of a torus of 32 x 16 quads differs from that of the torus, so the two references differ.
    const auto baseOf = [&](const char* file) {
        return readFrame(folder_ / "out/frames" / file).metadata.at("base");
    };
    const bool basesDiffer = baseOf("reference.exr") != baseOf("reference_proxy.exr");
    EXPECT_EQ(results["base_gap"]["silhouette"]["iou"] < 1.0, basesDiffer);
    EXPECT_GT(results["base_gap"]["silhouette"]["iou"], 0.9);
}

// The control draws the triangles on the limit surface, although those on the proxy exist too.
TEST_F(Validate, Control_UsesLimitSurface) {
    writeSmallScene();
    ASSERT_EQ(validate("out", {"--base", "both", "--technique", "micro_triangles"}).exitCode, 0);
    const json technique = resultsOf("out")["techniques"][0];
    EXPECT_GE(technique["silhouette"]["iou"], 0.999);
    expectDepthWithinCertificate(resultsOf("out"));
}

TEST_F(Validate, OneBase_HasNoGap) {
    writeSmallScene();
    ASSERT_EQ(validate("out", {"--base", "proxy", "--technique", "linear_binary"}).exitCode, 0);
    const json results = resultsOf("out");
    EXPECT_EQ(results["base"], "proxy");
    for (const char* key : {"base_gap", "reference_proxy"})
        EXPECT_FALSE(results.contains(key)) << key;
    EXPECT_FALSE(results["techniques"][0].contains("against_proxy"));
    EXPECT_FALSE(fs::exists(folder_ / "out/frames/reference_proxy.exr"));
}

// --- errors

void expectRefused(const Outcome& outcome, int exitCode, const std::string& part) {
    EXPECT_EQ(outcome.signal, 0) << "crashed: " << part;
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(part));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(Validate, WrongNames_AreRefusedFirst) {
    writeSmallScene();
    expectRefused(validate("out", {"--technique", "linear_binry"}), 2, "did you mean 'linear_binary'?");
    expectRefused(validate("out", {"--technique", "./nowhere"}), 2, "nowhere");
    expectRefused(validate("out", {"--technique", "linear_binary@cubic"}), 2, "cubic");
    expectRefused(validate("out", {"--technique", "linear_binary:steps"}), 2, "steps");
    expectRefused(validate("out", {"--technique", "linear_binary", "--technique", "linear_binary"}), 2,
                  "twice");
    expectRefused(validate("out", {"--set", "linear_stepps=5"}), 2, "did you mean 'linear_steps'?");
    expectRefused(validate("out", {"--set", "linear_steps"}), 2, "--set");
    expectRefused(validate("out", {"--gl", "vulkan"}), 2, "--gl");
    expectRefused(validate("out", {"--base", "bth"}), 2, "did you mean 'both'?");
    expectRefused(validate("out", {"--error-px", "0"}), 2, "--error-px");
    expectRefused(run({"realtime", "small.toml"}), 2, "--technique");
    EXPECT_EQ(filesBelow(folder_), std::vector<std::string>{"small.toml"});
}

TEST_F(Validate, MissingDevice_ExitsWith3) {
    writeSmallScene();
    expectRefused(validate("out", {"--gl", "egl", "--device", "99"}), 3, "99");
    EXPECT_EQ(filesBelow(folder_), std::vector<std::string>{"small.toml"});
}

TEST_F(Validate, UnwritableFolder_IsRefused) {
    writeSmallScene();
    expectRefused(validate("small.toml/out"), 2, "small.toml");
    writeFile(folder_ / "blocked", "a file where a folder should be");
    expectRefused(validate("blocked"), 2, "blocked");
    fs::create_directories(folder_ / "out");
    writeFile(folder_ / "out/frames", "a file where a folder should be");
    expectRefused(validate("out"), 2, "frames");
    EXPECT_FALSE(fs::exists(folder_ / "out/results.json"));
}

TEST_F(Validate, TwoIntoOneFolder_SecondIsRefused) {
    writeSmallScene();
    const Running first = startProgram(
        {"validate", "small.toml", "--rate", "16", "--technique", "linear_binary", "-o", "out"}, folder_);
    // It has both locks, those of out and out/frames, before it computes the reference.
    ASSERT_TRUE(waitUntil([&] { return fs::exists(folder_ / "out/frames/reference.exr"); }, 30));
    sendSignal(first.process, SIGSTOP); // at work for as long as the others take
    expectRefused(validate("out", {"--technique", "cone_step"}), 3,
                  "out: another run of plumbline is writing here");
    expectRefused(run({"reference", "small.toml", "-o", "out/frames/reference.exr"}), 3,
                  "out/frames/reference.exr: another run of plumbline is writing here");
    sendSignal(first.process, SIGCONT);
    EXPECT_EQ(finish(first).exitCode, 0);
    EXPECT_EQ(resultsOf("out")["techniques"][0]["name"], "linear_binary");
    EXPECT_EQ(filesBelow(folder_ / "out/frames"),
              (std::vector<std::string>{"linear_binary.exr", "reference.exr"}));
    EXPECT_EQ(validate("out", {"--technique", "cone_step"}).exitCode, 0);
}

// Libraries that are refused address space while they are loaded, or threads, crash or wait for ever.
TEST_F(Validate, AddressSpaceLimits_AreAnErrorOrEnough) {
    writeSmallScene();
    for (int megabytes = 250; megabytes <= 1150; megabytes += 50) {
        const Outcome outcome =
            runScript("ulimit -c 0; ulimit -v " + std::to_string(megabytes * 1024) +
                      "; exec $PLUMBLINE validate small.toml --rate 4 --technique linear_binary -o out");
        SCOPED_TRACE(std::to_string(megabytes) + " MB: " + outcome.err);
        EXPECT_EQ(outcome.signal, 0);
        EXPECT_THAT(outcome.exitCode, ::testing::AnyOf(0, 3));
    }
}

/// Expects that a broken technique is recorded and the other one has figures.
void expectOnlySecondFailed(const Outcome& outcome, const json& results, const std::string& part) {
    EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("failed"));
    ASSERT_EQ(results["techniques"].size(), 3u);
    EXPECT_TRUE(results["techniques"][0]["error"].is_null());
    EXPECT_THAT(results["techniques"][1]["error"].get<std::string>(), HasSubstr(part));
    EXPECT_FALSE(results["techniques"][1].contains("silhouette"));
    EXPECT_TRUE(results["techniques"][2]["error"].is_null()); // the context survives a failure
    EXPECT_GT(results["techniques"][2]["silhouette"]["iou"], 0.5);
}

TEST_F(Validate, CompileError_IsRowWithMessage) {
    writeSmallScene();
    const fs::path mine = copyTechnique("mine");
    const std::string text = readFile(mine / "mine.glsl");
    writeFile(mine / "mine.glsl", "float wrong = undeclared;\n" + text);
    const Outcome made = validate("out", {"--technique", "normal_mapping", "--technique", mine.string(),
                                          "--technique", "linear_binary"});
    expectOnlySecondFailed(made, resultsOf("out"), "mine.glsl:1"); // file and line of the technique's source
    EXPECT_EQ(filesBelow(folder_ / "out/frames").size(),
              3u); // the reference and the two techniques that worked
    EXPECT_NE(readFile(folder_ / "out/report/index.html").find("mine.glsl:1"), std::string::npos);
}

TEST_F(Validate, BadManifest_IsRowWithMessage) {
    writeSmallScene();
    const fs::path mine = copyTechnique("mine");
    const std::string manifest = readFile(mine / "technique.toml");
    const std::vector<std::string> chosen{"--technique", "normal_mapping", "--technique",
                                          mine.string(), "--technique",    "linear_binary"};
    for (const auto& [damaged, part] :
         {std::pair<std::string, std::string>{"color = 1\n" + manifest, "color"},
          {manifest.substr(manifest.find('\n')), "title"},
          {manifest.substr(0, manifest.size() / 2), "technique.toml"}}) {
        writeFile(mine / "technique.toml", damaged);
        const Outcome made = validate("out", chosen);
        expectOnlySecondFailed(made, resultsOf("out"), part);
    }
}

TEST_F(Validate, TechniqueFromFolder_Runs) {
    writeSmallScene();
    copyTechnique("mine");
    const Outcome made = validate("out", {"--technique", "./mine", "--technique", "linear_binary"});
    ASSERT_EQ(made.exitCode, 0) << made.err << made.out;
    const json results = resultsOf("out");
    EXPECT_EQ(results["techniques"][0]["silhouette"], results["techniques"][1]["silhouette"]);
    EXPECT_EQ(results["techniques"][0]["depth"], results["techniques"][1]["depth"]);
}

TEST_F(Validate, EarlierResults_AreReplaced) {
    writeSmallScene();
    ASSERT_EQ(validate("out", {"--technique", "linear_binary"}).exitCode, 0);
    ASSERT_EQ(validate("out", {"--technique", "normal_mapping"}).exitCode, 0);
    const json results = resultsOf("out");
    ASSERT_EQ(results["techniques"].size(), 1u);
    EXPECT_EQ(results["techniques"][0]["name"], "normal_mapping");
}

// spot (Keenan Crane, public domain): a mesh with its own uvs, and a map that stores depth.
TEST_F(Validate, SpotWithToyBoxMap_Runs) {
    const fs::path data = PLUMBLINE_SHARED_DATA;
    if (!fs::exists(data / "spot_control_mesh.obj"))
        GTEST_SKIP() << "not there: " << data / "spot_control_mesh.obj";
    writeFile(folder_ / "small.toml", R"(purpose = "Spot"
[camera]
position = [2, 1.2, -2.6]
target = [0, 0.1, 0.1]
fov_y_degrees = 40
width = 96
height = 72
[[light]]
name = "sun"
to_light = [0.7, 0.6, -0.5]
[[height_map]]
name = "toy_box"
file = ")" + (data / "toy_box_disp.png").string() +
                                          R"("
stores = "depth"
[[object]]
name = "spot"
mesh = ")" + (data / "spot_control_mesh.obj").string() +
                                          R"("
relief = { map = "toy_box", depth = 0.05, tile = [4, 4] }
)");
    const Outcome made = validate("out");
    ASSERT_EQ(made.exitCode, 0) << made.err << made.out;
    const json results = resultsOf("out");
    for (const json& technique : results["techniques"])
        EXPECT_GT(technique["silhouette"]["iou"], 0.5);
}

// A technique that returns NaN where it fails must not get better figures without a warning.
TEST_F(Validate, NanHits_AreReported) {
    writeSmallScene();
    fs::create_directories(folder_ / "nan");
    writeFile(folder_ / "nan/technique.toml",
              "title = 'NaN'\ncitation = 'me'\ninputs = ['height']\nneeds = []\nlimits = []\n");
    writeFile(folder_ / "nan/nan.glsl", "ReliefHit traceRelief(ReliefRay ray) {\n"
                                        "    float depth = reliefDepth(ray.st);\n"
                                        "    return hitAt(ray, depth > 0.5 ? sqrt(-depth) : depth);\n}\n");
    const Outcome outcome = validate("out", {"--technique", "nan", "--technique", "normal_mapping"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("warning: nan: "));
    EXPECT_THAT(outcome.err,
                HasSubstr("covered pixels have a position, depth, normal or st that isn't a number"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("normal_mapping: ")));
    EXPECT_THAT(resultsOf("out")["techniques"][0]["notes"].dump(), HasSubstr("figures leave them out"));
}

// What a search may not return is counted by kind, and said.
TEST_F(Validate, HitsOffTheRay_AreReported) {
    writeSmallScene();
    struct Case {
        const char *body, *figure, *sentence;
    };
    const Case cases[] = {
        {"return hitAt(ray, 2.0);", "t_outside_px", "covered pixels have a hit with t outside [0, 1]"},
        {"return hitAt(ray, -0.01);", "t_outside_px", "covered pixels have a hit with t outside [0, 1]"},
        {"return ReliefHit(true, 0.5, ray.st + 0.01);", "off_ray_px", "have a hit whose st isn't the ray's"},
        {"return ReliefHit(true, 0.5, vec2(0.0) / 0.0 * ray.st);", "not_finite_px", "st that isn't a number"},
        {"return ReliefHit(true, 1.0 / 0.0, ray.st);", "not_finite_px", "isn't a number"},
        {"return ReliefHit(true, 1e30, ray.st);", "t_outside_px", "t outside [0, 1]"},
    };
    for (const Case& each : cases) {
        fs::create_directories(folder_ / "odd");
        writeFile(folder_ / "odd/technique.toml",
                  "title = 'Odd'\ncitation = 'me'\ninputs = ['height']\nneeds = []\nlimits = []\n");
        writeFile(folder_ / "odd/odd.glsl",
                  std::string("ReliefHit traceRelief(ReliefRay ray) {\n    ") + each.body + "\n}\n");
        const Outcome outcome = validate("out", {"--technique", "odd", "--technique", "exact_cells"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("warning: odd: ")) << each.body;
        EXPECT_THAT(outcome.err, HasSubstr(each.sentence)) << each.body;
        EXPECT_THAT(outcome.err, Not(HasSubstr("exact_cells: "))) << each.body;
        const json techniques = resultsOf("out")["techniques"];
        EXPECT_GT(techniques[0]["fault"][each.figure], 0) << each.body;
        EXPECT_THAT(techniques[0]["notes"].dump(), HasSubstr(each.sentence)) << each.body;
        for (const char* figure : {"not_finite_px", "t_outside_px", "off_ray_px"})
            EXPECT_EQ(techniques[1]["fault"][figure], 0) << figure;
    }
}

// A sheet seen from behind; its technique shows it as the reference does.
TEST_F(Validate, SheetFromBehind_IsDrawnAndSaid) {
    const auto write = [&](const std::string& cull) {
        writeFile(folder_ / "small.toml", R"(purpose = "A sheet from behind"
[camera]
position = [0.4, -2.0, 0.9]
width = 96
height = 72
[[light]]
name = "sun"
to_light = [0.4, -0.8, 0.5]
[[object]]
name = "sheet"
shape = { kind = "plane" }
scheme = "none"
)" + cull);
    };
    write("");
    const Outcome shown = validate("out", {"--technique", "linear_binary", "--technique", "linear"});
    ASSERT_EQ(shown.exitCode, 0);
    const std::string said = "warning: the reference shows the back side of 'sheet' in ";
    EXPECT_THAT(shown.err, HasSubstr(said));
    EXPECT_EQ(shown.err.find(said), shown.err.rfind(said)) << "once for all techniques";
    json technique = resultsOf("out")["techniques"][0];
    EXPECT_GT(technique["silhouette"]["back_px"], 1000);
    EXPECT_EQ(technique["silhouette"]["missing_back_px"], 0);
    EXPECT_GT(technique["silhouette"]["iou"], 0.99);
    EXPECT_THAT(technique["notes"].dump(), HasSubstr("the reference shows the back side of 'sheet' in "));
    write("cull = \"back\"\n");
    ASSERT_EQ(validate("culled", {"--technique", "linear_binary"}).exitCode, 0);
    technique = resultsOf("culled")["techniques"][0];
    EXPECT_EQ(technique["silhouette"]["union_px"], 0);
    EXPECT_EQ(technique["silhouette"]["absent"]["iou"], "neither frame shows it");
}

TEST_F(Validate, RefusedSurface_HasReason) {
    writeSmallScene();
    const Outcome outcome = validate("out", {"--technique", "sphere_tracing@quadric"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err,
                HasSubstr("'sphere_tracing' has no surface 'quadric': the search needs flat_base"));
}

TEST_F(Validate, All_HoldsVariantsWithOneSearch) {
    writeSmallScene();
    // Techniques that `all` contains can't be named in addition: `linear` on the variant isn't in it,
    // `linear_binary` on it is.
    const Outcome outcome = validate("out", {"--technique", "all", "--technique", "linear@quadric_nearest",
                                             "--technique", "linear_binary@quadric_nearest"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, HasSubstr("'linear_binary@quadric_nearest' is named twice"));
    EXPECT_THAT(validate("out", {"--technique", "all", "--technique", "linear@quadric"}).err,
                HasSubstr("'linear@quadric' is named twice"));
}

TEST_F(Validate, OutputOverInput_IsRefused) {
    writeSmallScene();
    const std::string before = readFile(folder_ / "small.toml");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"realtime", "small.toml", "--technique", "linear", "-o", "small.toml"},
          std::vector<std::string>{"reference", "small.toml", "-o", "./small.toml"},
          std::vector<std::string>{"bake", "small.toml#stone", "--kind", "max_mipmap", "-o", "small.toml"}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments[0];
        EXPECT_THAT(outcome.err, HasSubstr("this file is an input and would be overwritten"));
        EXPECT_EQ(readFile(folder_ / "small.toml"), before);
    }
}

} // namespace
} // namespace plumbline
