// Techniques that loop forever or crash their process: they fail, but the run continues.
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <thread>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using namespace test;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Compilers can't know that depths are never below -1. llvmpipe ends any loop after 65535 iterations, so each
// takes long enough that no machine finishes within the limits below.
std::string endlessSearch() {
    std::string round;
    for (int i = 0; i < 16; ++i)
        round += "position.x += 0.001 + 0.001 * reliefDepth(position.xy);\n";
    return "ReliefHit traceRelief(ReliefRay ray) {\n"
           "vec3 position = reliefPosition(ray, 0.5);\n"
           "while (reliefDepth(position.yx) > -1.0)\n"
           "while (reliefDepth(position.xy) > -1.0) {\n" +
           round + "}\nreturn hitAt(ray, position.x);\n}\n";
}
const std::string kStopped =
    "endless: not finished after 2 s and stopped; expected a search whose loops terminate; "
    "--time-limit SECONDS raises the limit";

class TimeLimit : public EndToEnd {
  protected:
    void SetUp() override {
        writeSmallScene();
        fs::create_directories(folder_ / "endless");
        writeFile(folder_ / "endless" / "technique.toml",
                  "title = \"Endless\"\ncitation = \"none\"\ninputs = [\"height\"]\n"
                  "needs = []\nlimits = []\n");
        writeFile(folder_ / "endless" / "endless.glsl", endlessSearch());
    }
    void TearDown() override {
        if (drawing_ > 0 && !isGone(drawing_))
            sendSignal(drawing_, SIGKILL); // after a failed test it would run forever
        if (!running_.captured.empty()) fs::remove_all(running_.captured);
    }

    static std::vector<std::string> validate(const std::vector<std::string>& techniques,
                                             const std::string& limitSeconds) {
        std::vector<std::string> arguments{"validate", "small.toml", "--rate",       "16",
                                           "-o",       "out",        "--time-limit", limitSeconds};
        for (const std::string& technique : techniques)
            arguments.insert(arguments.end(), {"--technique", technique});
        return arguments;
    }

    json techniques() const { return json::parse(readFile(folder_ / "out/results.json"))["techniques"]; }

    /// Starts a run, waits until it executes the endless shader, the second of three techniques, and returns
    /// the drawing process.
    pid_t startAndReachTheLoop(const std::string& limitSeconds = "60") {
        running_ = startProgram(validate({"normal_mapping", "./endless", "linear_binary"}, limitSeconds),
                                folder_, {}, true);
        const bool first = waitUntil([&] { return fs::exists(folder_ / "out/results.json"); }, 60);
        EXPECT_TRUE(first) << "no results of the first technique";
        std::this_thread::sleep_for(std::chrono::milliseconds(300)); // compiling takes a tenth of that
        const std::vector<pid_t> children = childrenOf(running_.process);
        EXPECT_EQ(children.size(), 1u);
        return drawing_ = children.empty() ? -1 : children[0];
    }

    /// Expects that the endless technique failed with a message that contains this part and the others have
    /// figures.
    void expectOnlyTheSecondFailed(const std::string& part) const {
        const json results = techniques();
        ASSERT_EQ(results.size(), 3u);
        EXPECT_THAT(results[1]["error"].get<std::string>(), HasSubstr(part));
        EXPECT_FALSE(results[1].contains("silhouette"));
        for (const size_t good : {0u, 2u}) {
            EXPECT_TRUE(results[good]["error"].is_null()) << results[good]["error"];
            EXPECT_GT(results[good]["silhouette"]["iou"], 0.5);
        }
    }

    Running running_;
    pid_t drawing_ = -1;
};

TEST_F(TimeLimit, EndlessShader_LeavesOthersRunning) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome made = run(validate({"./endless", "linear_binary"}, "2"));
    EXPECT_LT(std::chrono::steady_clock::now() - start,
              std::chrono::seconds(30)); // about 4 s on an idle machine
    EXPECT_EQ(made.exitCode, 2);
    expectOnlyTheCertificate(made.err);
    EXPECT_THAT(made.out, HasSubstr(kStopped));
    EXPECT_EQ(techniques()[0]["error"], kStopped);
    EXPECT_TRUE(techniques()[1]["error"].is_null());
    EXPECT_GT(techniques()[1]["silhouette"]["iou"], 0.5);
    EXPECT_FALSE(fs::exists(folder_ / "out/frames/endless.exr"));
}

TEST_F(TimeLimit, EndlessShader_FailsWithoutFile) {
    const Outcome made =
        run({"realtime", "small.toml", "--technique", "./endless", "--time-limit", "2", "-o", "frame.exr"});
    EXPECT_EQ(made.exitCode, 2);
    EXPECT_EQ(made.err, kStopped + "\n");
    EXPECT_THAT(made.out, IsEmpty());
    EXPECT_FALSE(fs::exists(folder_ / "frame.exr"));
}

TEST_F(TimeLimit, KilledWorker_CostsOneTechnique) {
    const pid_t drawing = startAndReachTheLoop();
    ASSERT_EQ(sendSignal(drawing, SIGKILL), 0);
    EXPECT_EQ(finish(running_).exitCode, 3);
    expectOnlyTheSecondFailed("endless: its process was killed (signal 9, SIGKILL); memory may have run out");
}

TEST_F(TimeLimit, CrashingDriver_CostsOneTechnique) {
    const pid_t drawing = startAndReachTheLoop();
    ASSERT_EQ(sendSignal(drawing, SIGSEGV), 0);
    const Outcome made = finish(running_);
    EXPECT_EQ(made.exitCode, 3);
    expectOnlyTheSecondFailed("endless: the OpenGL driver ended the process (");
}

TEST_F(TimeLimit, ParentsDeath_EndsWorker) {
    const pid_t drawing = startAndReachTheLoop();
    ASSERT_EQ(sendSignal(running_.process, SIGKILL), 0);
    EXPECT_EQ(finish(running_).signal, SIGKILL);
    EXPECT_TRUE(waitUntil([&] { return isGone(drawing); }, 2));
}

TEST_F(TimeLimit, CtrlC_EndsBothAndKeepsFinished) {
    const pid_t drawing = startAndReachTheLoop();
    ASSERT_EQ(sendSignalToGroup(running_.process, SIGINT), 0);
    EXPECT_TRUE(waitUntil([&] { return isGone(running_.process) && isGone(drawing); }, 2));
    const Outcome stopped = finish(running_);
    EXPECT_EQ(stopped.signal, SIGINT);
    EXPECT_THAT(stopped.out, IsEmpty());
    expectOnlyTheCertificate(stopped.err);
    ASSERT_EQ(techniques().size(), 1u);
    EXPECT_GT(techniques()[0]["silhouette"]["iou"], 0.5);
    EXPECT_TRUE(fs::exists(folder_ / "out/report/index.html"));
}

// The parent receives them too. If the drawing process ended because of one, the parent would report a crash.
TEST_F(TimeLimit, Signals_AreLeftToParent) {
    const pid_t drawing = startAndReachTheLoop();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
        ASSERT_EQ(sendSignal(drawing, signal), 0);
    EXPECT_FALSE(waitUntil([&] { return isGone(drawing); }, 0.3));
    ASSERT_EQ(sendSignal(running_.process, SIGTERM), 0);
    EXPECT_EQ(finish(running_).signal, SIGTERM);
    EXPECT_TRUE(waitUntil([&] { return isGone(drawing); }, 2));
}

// A stopped process can't draw, so the time limit doesn't run.
TEST_F(TimeLimit, CtrlZ_StopsTheClock) {
    startAndReachTheLoop("3");
    ASSERT_EQ(sendSignalToGroup(running_.process, SIGSTOP), 0);
    std::this_thread::sleep_for(std::chrono::seconds(4));
    ASSERT_EQ(sendSignalToGroup(running_.process, SIGCONT), 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    EXPECT_EQ(techniques().size(), 1u) << "stopped before its 3 s were over";
    EXPECT_EQ(finish(running_).exitCode, 2);
    expectOnlyTheSecondFailed("not finished after 3 s");
}

TEST_F(TimeLimit, ChangedScene_IsRefused) {
    startAndReachTheLoop("2");
    writeFile(folder_ / "small.toml", withLine(kSmallScene, "depth = 0.1", "depth = 0.2"));
    EXPECT_EQ(finish(running_).exitCode, 2);
    ASSERT_EQ(techniques().size(), 3u);
    EXPECT_THAT(techniques()[2]["error"].get<std::string>(),
                HasSubstr("small.toml: the scene changed during the run"));
}

TEST_F(TimeLimit, Worker_PrintsNothingOnStdout) {
    const fs::path fds = "/proc/" + std::to_string(startAndReachTheLoop()) + "/fd";
    const fs::path itsOut = fs::read_symlink(fds / "1"), itsErr = fs::read_symlink(fds / "2");
    EXPECT_EQ(itsErr, running_.captured / "err");
    EXPECT_EQ(itsOut, itsErr);
    sendSignal(running_.process, SIGKILL);
    finish(running_);
}

TEST_F(TimeLimit, SceneWarnings_ArePrintedOnce) {
    writeFile(folder_ / "small.toml",
              withLine(kSmallScene, R"(shape = { kind = "plane", width = 6, depth = 6, segments = [2, 2] })",
                       "shape = { kind = \"box\" }\nscheme = \"none\"\n"
                       "relief = { map = \"stone\", depth = 0.1, seams = \"open\" }"));
    const Outcome made = run(validate({"normal_mapping"}, "60"));
    EXPECT_EQ(made.exitCode, 0) << made.err;
    const std::string warning = "warning: floor: 12 edges where normals tear the surface";
    const size_t first = made.err.find(warning);
    ASSERT_NE(first, std::string::npos) << made.err;
    EXPECT_EQ(made.err.find(warning, first + 1), std::string::npos) << made.err;
}

TEST_F(EndToEnd, InternalCommand_IsRefusedForUsers) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"draw-worker"}, {"draw-worker", "1"}}) {
        const Outcome refused = run(words);
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_EQ(refused.err, "plumbline: 'draw-worker' is an internal command; expected one of the "
                               "commands that --help lists\n");
        EXPECT_THAT(refused.out, IsEmpty());
    }
    EXPECT_THAT(run({"--help"}).out, Not(HasSubstr("draw-worker")));
    EXPECT_THAT(run({"draw"}).err, Not(HasSubstr("draw-worker")));
}

} // namespace
} // namespace plumbline
