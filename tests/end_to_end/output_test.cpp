// Where results go: links, modes, limits, full disks, closed streams, odd paths, two runs at once.
#include "tests/end_to_end/program.h"
#include "tests/validate/results/sample_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class Output : public EndToEnd {
  protected:
    void SetUp() override { writeFile(folder_ / "r.json", toJson(sampleResults())); }
    /// Results of `count` scenes, 1.json and so on.
    void writeResults(int count) const {
        for (int i = 1; i <= count; ++i) {
            Results results = sampleResults();
            results.scene.name = fmt::format("scene{}", i);
            writeFile(folder_ / fmt::format("{}.json", i), toJson(results));
        }
    }
    long lines(const std::string& file) const {
        const std::string text = readFile(folder_ / file);
        return std::count(text.begin(), text.end(), '\n');
    }
    /// Files of runs, not results.
    std::vector<std::string> leftOver() const {
        std::vector<std::string> files = filesBelow(folder_);
        std::erase_if(files,
                      [](const std::string& file) { return file.find(".plumbline-") == std::string::npos; });
        return files;
    }
};

TEST_F(Output, TwentyHistoriesAtOnce_KeepTwentyRecords) {
    writeResults(20);
    const Outcome all =
        runScript("for i in $(seq 20); do $PLUMBLINE history h.jsonl $i.json >/dev/null & "
                  "processes+=\" $!\"; done; for p in $processes; do wait $p || echo failed; done");
    EXPECT_EQ(all.err + all.out, "");
    EXPECT_EQ(lines("h.jsonl"), 20);
    EXPECT_TRUE(leftOver().empty());
}

TEST_F(Output, LinkedPrivateHistory_StaysLinkedAndPrivate) {
    writeFile(folder_ / "real.jsonl", "");
    ASSERT_EQ(::chmod((folder_ / "real.jsonl").c_str(), 0600), 0);
    fs::create_symlink("real.jsonl", folder_ / "h.jsonl");
    EXPECT_EQ(run({"history", "h.jsonl", "r.json"}).exitCode, 0);
    EXPECT_TRUE(fs::is_symlink(folder_ / "h.jsonl"));
    EXPECT_EQ(lines("real.jsonl"), 1);
    EXPECT_EQ(fs::status(folder_ / "real.jsonl").permissions(), fs::perms(0600));
}

TEST_F(Output, UnwritableStdout_IsAnError) {
    for (const char* command : {"list metrics", "list scenes", "--help", "history --help", "--version",
                                "doctor", "history h.jsonl r.json"})
        for (const char* where : {"> /dev/full", ">&-"}) {
            const Outcome outcome = runScript(fmt::format("$PLUMBLINE {} {}", command, where));
            SCOPED_TRACE(fmt::format("{} {}", command, where));
            expectRefusal(outcome, 3, "standard output: not all of it can be written");
        }
}

// A reader that has read enough, such as head, ends the program as it ends any other: without a message.
TEST_F(Output, ClosedPipe_EndsQuietly) {
    const Outcome outcome = runScript("$PLUMBLINE list metrics | true; echo ${PIPESTATUS[0]}");
    EXPECT_TRUE(outcome.out == "0\n" || outcome.out == "141\n") << outcome.out; // 141: SIGPIPE
    EXPECT_EQ(outcome.err, "");
}

// Descriptor 1 is the lowest free one: a file opened for results must not get it.
TEST_F(Output, ClosedStdout_LeavesFramesWhole) {
    writeSmallScene();
    const std::vector<std::string> frame{"reference", "small.toml", "--rate", "4", "-o", "a.exr"};
    ASSERT_EQ(run(frame).exitCode, 0);
    const Outcome outcome = runScript("$PLUMBLINE reference small.toml --rate 4 -o b.exr >&- <&-");
    EXPECT_EQ(outcome.exitCode, 3);
    EXPECT_EQ(readFile(folder_ / "a.exr"), readFile(folder_ / "b.exr"));
}

TEST_F(Output, FileSizeLimit_IsAnErrorWithoutFiles) {
    writeSmallScene();
    writeResults(20);
    for (const char* command : {"reference small.toml --rate 4 -o a.exr",
                                "reference small.toml --rate 4 -o b.exr --export-mesh m.ply",
                                "history h.jsonl 1.json 2.json 3.json 4.json 5.json 6.json 7.json 8.json"}) {
        const auto before = filesBelow(folder_);
        const Outcome outcome = runScript(fmt::format("ulimit -f 2; exec $PLUMBLINE {}", command));
        expectRefusal(outcome, 3, "can't be written: File too large");
        EXPECT_EQ(filesBelow(folder_), before) << command;
    }
}

TEST_F(Output, TooFewThreads_IsAnError) {
    if (kAddressSanitizer) GTEST_SKIP() << "the leak sanitizer needs a thread";
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become a user without processes";
    writeSmallScene();
    fs::permissions(folder_, fs::perms::all);
    for (const int limit : {1, 2, 3}) {
        const Outcome outcome = runScript(
            fmt::format("exec setpriv --reuid=65534 --regid=65534 --clear-groups bash -c 'ulimit -u {}; exec "
                        "$PLUMBLINE reference small.toml --rate 4 -o a.exr'",
                        limit));
        if (outcome.err.find("setpriv") != std::string::npos) GTEST_SKIP() << outcome.err;
        expectRefusal(outcome, 3, "threads: this process can start");
    }
}

TEST_F(Output, AddressSpaceLimits_AreAnErrorOrEnough) {
    if (kAddressSanitizer) GTEST_SKIP() << "the address sanitizer reserves terabytes of address space";
    writeSmallScene();
    for (int megabytes = 100; megabytes <= 1600; megabytes += 250) {
        const Outcome outcome = runScript(
            fmt::format("ulimit -c 0; ulimit -v {}; exec $PLUMBLINE reference small.toml --rate 4 -o a.exr",
                        megabytes * 1024));
        SCOPED_TRACE(fmt::format("{} MB: {}", megabytes, outcome.err));
        EXPECT_EQ(outcome.signal, 0);
        EXPECT_THAT(outcome.exitCode, ::testing::AnyOf(0, 3));
    }
}

TEST_F(Output, TooLargeFrame_IsRefused) {
    if (kAddressSanitizer) GTEST_SKIP() << "the address sanitizer reserves terabytes of address space";
    writeSmallScene();
    const Outcome outcome = runScript("ulimit -v 4000000; exec $PLUMBLINE reference small.toml --scene-set "
                                      "camera.width=16384 --scene-set camera.height=16384 -o a.exr");
    expectRefusal(outcome, 3, "memory: a frame of 16384 x 16384 pixels and 1 lights needs 22.");
}

TEST_F(Output, OddPaths_AreRefusedBeforeWork) {
    writeSmallScene();
    fs::create_directory(folder_ / "dir");
    fs::create_symlink("loop", folder_ / "loop");
    fs::create_symlink("loop2", folder_ / "loop3");
    fs::create_symlink("loop3", folder_ / "loop2");
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    const std::string tooLong(256, 'n'), longest = std::string(251, 'n') + ".exr";
    const auto before = filesBelow(folder_);
    for (const std::string& path : {std::string(),
                                    std::string("-"),
                                    std::string("dir"),
                                    std::string("dir/"),
                                    std::string("/dev/null"),
                                    std::string("pipe"),
                                    std::string("loop"),
                                    std::string("loop2"),
                                    std::string("loop/a.exr"),
                                    std::string("small.toml"),
                                    std::string("./dir/../small.toml"),
                                    std::string("small.toml/a.exr"),
                                    std::string("new/"),
                                    std::string("."),
                                    std::string(".."),
                                    std::string("/"),
                                    tooLong,
                                    "dir/" + tooLong,
                                    tooLong + "/a.exr",
                                    std::string(5000, 'x'),
                                    std::string("a\nb/../small.toml/x")}) {
        SCOPED_TRACE(path);
        // 'all' micro-triangles would take long: the refusal comes before.
        const Outcome outcome = run({"reference", "small.toml", "--rate", "1024", "-o", path});
        expectRefusal(outcome, 2, "");
        EXPECT_THAT(outcome.err, ::testing::Not(HasSubstr("internal error")));
    }
    EXPECT_EQ(filesBelow(folder_), before);
    EXPECT_EQ(run({"reference", "small.toml", "--rate", "4", "-o", longest}).exitCode, 0);
}

TEST_F(Output, TwoFramesToOneFile_SecondIsRefused) {
    writeSmallScene();
    const Running first =
        startProgram({"reference", "stone_torus", "--rate", "256", "--memory", "4G", "-o", "a.exr"}, folder_);
    ASSERT_TRUE(waitUntil([&] { return !leftOver().empty(); }, 30)) << "no lock";
    const Outcome second = runScript("$PLUMBLINE reference small.toml --rate 4 -o a.exr");
    sendSignal(first.process, SIGTERM);
    finish(first);
    expectRefusal(second, 3, "another run of plumbline is writing here");
    EXPECT_TRUE(leftOver().empty()) << leftOver().front();
    EXPECT_EQ(run({"reference", "small.toml", "--rate", "4", "-o", "a.exr"}).exitCode, 0);
}

} // namespace
} // namespace plumbline
