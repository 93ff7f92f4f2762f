// Studies as a user runs them: complete, interrupted, killed and resumed, and with cases that fail.
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <thread>

namespace plumbline::test {
namespace {

using ::testing::HasSubstr;

class StudyRun : public EndToEnd {
  protected:
    /// Cases of `width` pixels, one for each depth of the torus.
    void writeStudy(const std::string& depths, const std::string& width = "48") const {
        writeFile(folder_ / "tiny.toml", R"(title = "Tiny"
purpose = "For tests"
memory = "64M"
[[grid]]
name = "main"
scenes = ["small.toml"]
scene_set = ["camera.height=36", "camera.width=)" +
                                             width +
                                             R"("]
[[grid.axis]]
name = "depth"
field = "object.torus.relief.depth"
values = [)" + depths + R"(]
[[grid.technique]]
label = "linear"
name = "linear:linear_steps=4"
[[grid.technique]]
label = "binary"
name = "linear_binary"
[[grid.pair]]
first = "binary"
second = "linear"
[[table]]
title = "Depth"
rows = "technique"
columns = "depth"
figure = "depth.rmse"
)");
        writeSmallScene();
    }
    size_t caseFiles() const {
        const auto files = filesBelow(folder_ / "out" / "cases");
        return static_cast<size_t>(std::count_if(
            files.begin(), files.end(), [](const std::string& file) { return file.ends_with(".json"); }));
    }
};

/// Number of lines of a CSV file that contain `text`.
size_t linesWith(const std::string& csv, const std::string& text) {
    size_t count = 0;
    for (size_t begin = 0; begin < csv.size();) {
        const size_t end = std::min(csv.find('\n', begin), csv.size());
        count += csv.substr(begin, end - begin).find(text) != std::string::npos;
        begin = end + 1;
    }
    return count;
}

TEST_F(StudyRun, FullRun_ComputesEachCaseOnce) {
    writeStudy("0.02, 0.05");
    const Outcome first = run({"study", "run", "tiny.toml", "-o", "out"});
    ASSERT_EQ(first.exitCode, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("2 cases: 2 computed in"));
    const std::string csv = readFile(folder_ / "out/results.csv");
    EXPECT_EQ(linesWith(csv, ",linear,reference,"), 2u);
    EXPECT_EQ(linesWith(csv, ",binary,reference,"), 2u);
    EXPECT_EQ(linesWith(csv, ",linear,binary,"), 2u); // the pair
    EXPECT_EQ(linesWith(csv, "small.toml,0.05,"), 3u);

    writeStudy("0.02, 0.05, 0.1");
    EXPECT_THAT(run({"study", "run", "tiny.toml", "-o", "out"}).out, HasSubstr("3 cases: 1 computed in"));
    const Outcome again = run({"study", "run", "tiny.toml", "-o", "out"});
    EXPECT_THAT(again.out, HasSubstr("3 cases: 0 computed in 0 s, 3 already stored, 0 failed"));

    const Outcome report = run({"study", "report", "tiny.toml", "-o", "out"});
    EXPECT_EQ(report.out, "out/report/index.html\n") << report.err;
    EXPECT_THAT(readFile(folder_ / "out/report/index.html"), HasSubstr("<th scope=\"row\">binary</th>"));
}

TEST_F(StudyRun, FailingCase_IsRecordedOthersRun) {
    writeStudy("0.02, -1, 0.05");
    const Outcome outcome = run({"study", "run", "tiny.toml", "-o", "out"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.out, HasSubstr("3 cases: 3 computed"));
    EXPECT_THAT(outcome.out, HasSubstr("1 failed"));
    EXPECT_THAT(outcome.err,
                HasSubstr("--scene-set object.torus.relief.depth=-1: is -1; expected a number from 0"));
    const std::string csv = readFile(folder_ / "out/results.csv");
    EXPECT_EQ(linesWith(csv, ",binary,reference,"), 2u);
    EXPECT_EQ(linesWith(csv, "is -1; expected"), 1u);
    // An error caused by the input remains, so the case isn't tried again.
    EXPECT_THAT(run({"study", "run", "tiny.toml", "-o", "out"}).out,
                HasSubstr("0 computed in 0 s, 3 already stored, 1 failed"));
}

TEST_F(StudyRun, FailingTechnique_CostsItsRows) {
    writeStudy("0.02, 0.05");
    std::filesystem::create_directory(folder_ / "mine");
    writeFile(folder_ / "mine/mine.glsl", "ReliefHit traceRelief(ReliefRay ray) { return nonsense; }\n");
    writeFile(folder_ / "mine/technique.toml",
              "title = \"t\"\ncitation = \"none\"\ninputs = [\"height\"]\nneeds = []\nlimits = []\n");
    const std::string study = readFile(folder_ / "tiny.toml");
    writeFile(folder_ / "tiny.toml",
              withLine(study, "name = \"linear:linear_steps=4\"", "name = \"./mine\""));
    const Outcome outcome = run({"study", "run", "tiny.toml", "-o", "out"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.out, HasSubstr("2 cases: 2 computed"));
    EXPECT_THAT(outcome.out, HasSubstr("2 failed"));
    EXPECT_EQ(linesWith(outcome.err, "linear: ./mine"), 1u) << outcome.err; // reported once for both cases
    const std::string csv = readFile(folder_ / "out/results.csv");
    EXPECT_EQ(linesWith(csv, "nonsense"), 4u); // the technique and its pair
    EXPECT_EQ(linesWith(csv, ",binary,reference,"), 2u);
    // The fixed technique has another hash, so the cases are new.
    writeFile(folder_ / "mine/mine.glsl",
              "ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, reliefDepth(ray.st)); }\n");
    const Outcome mended = run({"study", "run", "tiny.toml", "-o", "out"});
    EXPECT_EQ(mended.exitCode, 0) << mended.err;
    EXPECT_THAT(mended.out, HasSubstr("2 cases: 2 computed"));
}

TEST_F(StudyRun, Killed_Resumes) {
    // Images that take about a second each.
    writeStudy("0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09", "4000");
    const Running running = startProgram({"study", "run", "tiny.toml", "-o", "out", "--jobs", "1"}, folder_);
    ASSERT_TRUE(waitUntil([&] { return caseFiles() >= 2; }, 60));
    const std::vector<pid_t> children = childrenOf(running.process);
    ASSERT_EQ(sendSignal(running.process, SIGKILL), 0);
    EXPECT_EQ(finish(running).signal, SIGKILL);
    for (const pid_t child : children)
        EXPECT_TRUE(waitUntil([&] { return isGone(child); }, 10)) << "a case outlives its study";
    const size_t known = caseFiles();
    ASSERT_LT(known, 8u) << "all done before it was killed";
    const Outcome outcome = run({"study", "run", "tiny.toml", "-o", "out"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(std::to_string(8 - known) + " computed"));
    EXPECT_THAT(outcome.out, HasSubstr(std::to_string(known) + " already stored, 0 failed"));
}

// Killed before it is marked, a folder holds no results yet.
TEST_F(StudyRun, FolderWithoutMark_IsTakenUnlessFilesAreInIt) {
    writeStudy("0.02");
    writeFile(folder_ / "out/.plumbline-0123456789abcdef.tmp", "half a mark");
    EXPECT_EQ(run({"study", "run", "tiny.toml", "-o", "out"}).exitCode, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out/.plumbline-0123456789abcdef.tmp"));
    writeFile(folder_ / "mine/notes.txt", "not of a study");
    EXPECT_THAT(run({"study", "run", "tiny.toml", "-o", "mine"}).err,
                HasSubstr("contains files that don't belong to a study"));
    EXPECT_EQ(filesBelow(folder_ / "mine").size(), 1u);
}

TEST_F(StudyRun, TwoAtOnce_ShareTheCases) {
    writeStudy("0.02, 0.03, 0.04, 0.05, 0.06, 0.07", "1000");
    const std::vector<std::string> study{"study", "run", "tiny.toml", "-o", "out", "--jobs", "1"};
    const Running first = startProgram(study, folder_), second = startProgram(study, folder_);
    int computed = 0;
    for (const Running& each : {first, second}) {
        const Outcome outcome = finish(each);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_THAT(outcome.out, ::testing::StartsWith("6 cases: "));
        const int here = std::stoi(outcome.out.substr(std::string("6 cases: ").size()));
        EXPECT_GT(here, 0) << "the other did all";
        computed += here;
    }
    EXPECT_EQ(computed, 6);
    EXPECT_EQ(linesWith(readFile(folder_ / "out/results.csv"), ",linear,reference,"), 6u);
    EXPECT_EQ(caseFiles(), 6u);
}

// The other run waits for what this one has claimed, and does it when this one is gone.
TEST_F(StudyRun, KilledWhileAnotherWaits_IsTakenOver) {
    writeStudy("0.02", "4000");
    const std::vector<std::string> study{"study", "run", "tiny.toml", "-o", "out", "--jobs", "1"};
    const Running first = startProgram(study, folder_);
    ASSERT_TRUE(waitUntil([&] { return !childrenOf(first.process).empty(); }, 30));
    const Running second = startProgram(study, folder_);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    sendSignal(first.process, SIGKILL);
    EXPECT_EQ(finish(first).signal, SIGKILL);
    const Outcome outcome = finish(second);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("1 cases: 1 computed"));
}

TEST_F(StudyRun, Interrupted_EndsAtOnce) {
    writeStudy("0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09", "4000");
    const Running running = startProgram({"study", "run", "tiny.toml", "-o", "out"}, folder_, {}, true);
    ASSERT_TRUE(waitUntil([&] { return caseFiles() >= 1; }, 60));
    const std::vector<pid_t> children = childrenOf(running.process);
    ASSERT_EQ(sendSignalToGroup(running.process, SIGINT), 0);
    EXPECT_TRUE(waitUntil([&] { return isGone(running.process); }, 2));
    EXPECT_EQ(finish(running).signal, SIGINT);
    for (const pid_t child : children)
        EXPECT_TRUE(waitUntil([&] { return isGone(child); }, 10));
    // The report shows the finished cases.
    EXPECT_EQ(run({"study", "report", "tiny.toml", "-o", "out"}).exitCode, 0);
    EXPECT_THAT(readFile(folder_ / "out/report/index.html"), HasSubstr("cases have no results yet"));
}

TEST_F(StudyRun, BadStudy_IsRefusedFirst) {
    const auto errorOf = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exitCode, 2);
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    writeStudy("0.02");
    const std::string study = readFile(folder_ / "tiny.toml");
    writeFile(folder_ / "tiny.toml", withLine(study, "values = [0.02]", "values = [0.02]\nfiled = 3"));
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out"}),
                HasSubstr("grid.axis.filed: unknown field"));
    writeFile(folder_ / "tiny.toml", withLine(study, "name = \"linear_binary\"", "name = \"linear_binry\""));
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out"}),
                HasSubstr("did you mean 'linear_binary'?"));
    writeFile(folder_ / "tiny.toml",
              withLine(study, "values = [0.02]", "range = [0.01, 1]\nsteps = 1000000"));
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out"}),
                HasSubstr("tiny.toml: has 1000000 cases; expected at most 2000 without --yes"));
    writeFile(folder_ / "tiny.toml",
              withLine(study, "name = \"linear_binary\"", "name = \"linear_binary:linear_steps=0\""));
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out"}),
                HasSubstr("linear_steps = '0'; expected a whole number"));
    writeFile(folder_ / "tiny.toml", withLine(study, "memory = \"64M\"", "memory = \"64Q\""));
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out"}), HasSubstr("64Q"));
    writeFile(folder_ / "tiny.toml", study);
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out", "--gl", "elg"}),
                HasSubstr("expected auto, egl or osmesa"));
    EXPECT_EQ(filesBelow(folder_).size(), 2u); // study and scene only
    EXPECT_EQ(errorOf({"study", "report", "tiny.toml", "-o", "out"}),
              "out: contains no results of a study; expected the folder of 'plumbline study run tiny'\n");
    EXPECT_THAT(errorOf({"study", "run", "nosuch"}),
                HasSubstr("neither a file nor a study is called 'nosuch'"));
    writeFile(folder_ / "other.toml", study);
    ASSERT_EQ(run({"study", "run", "other.toml", "-o", "out"}).exitCode, 0);
    EXPECT_THAT(errorOf({"study", "run", "tiny.toml", "-o", "out"}),
                HasSubstr("contains the results of study 'other'"));
    EXPECT_THAT(errorOf({"study-case", "1"}), HasSubstr("'study-case' is an internal command"));
}

} // namespace
} // namespace plumbline::test
