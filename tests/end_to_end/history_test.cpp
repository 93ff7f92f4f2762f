// plumbline history: stores results, and exits with 1 if they became worse.
#include "tests/end_to_end/program.h"
#include "tests/validate/results/sample_results.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::Not;

class History : public EndToEnd {
  protected:
    void SetUp() override {
        Results worse = sampleResults(), better = sampleResults();
        setFigure(worse.techniques[0].comparison.pooled, "depth.rmse", 0.75);
        setFigure(better.techniques[0].comparison.pooled, "depth.rmse", 0.25);
        Results base = sampleResults();
        setFigure(base.techniques[0].comparison.pooled, "depth.rmse", 0.5);
        writeFile(folder_ / "base.json", toJson(base));
        writeFile(folder_ / "worse.json", toJson(worse));
        writeFile(folder_ / "better.json", toJson(better));
    }
    Outcome history(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"history", "h.jsonl"});
        return run(arguments);
    }
    std::string file() const { return readFile(folder_ / "h.jsonl"); }
    long lines() const {
        const std::string text = file();
        return std::count(text.begin(), text.end(), '\n');
    }
};

TEST_F(History, Regression_DecidesExitCode) {
    const Outcome first = history({"base.json", "--label", "v1"});
    EXPECT_EQ(first.exitCode, 0) << first.err;
    EXPECT_EQ(first.out, "painted: v1\nnote: the first record of this scene\n");
    const Outcome better = history({"better.json", "--label", "v2"});
    EXPECT_EQ(better.exitCode, 0) << better.err;
    EXPECT_THAT(better.out, HasSubstr("painted: from v1 to v2\n"));
    EXPECT_THAT(better.out, HasSubstr("linear_binary  depth.rmse     0.5   0.25   -0.25  better"));
    EXPECT_EQ(better.err, "");
    const Outcome worse = history({"worse.json", "--label", "v3"});
    EXPECT_EQ(worse.exitCode, 1);
    EXPECT_EQ(worse.err, "regression: painted: linear_binary: depth.rmse from 0.25 to 0.75; tolerated 0\n");
    EXPECT_EQ(lines(), 3);
    EXPECT_EQ(history({}).exitCode, 1); // compares only
    EXPECT_EQ(history({"--tolerance", "depth.rmse=0.5"}).exitCode, 0);
    EXPECT_EQ(lines(), 3);
}

TEST_F(History, DryRun_WritesNothing) {
    EXPECT_EQ(history({"base.json"}).exitCode, 0);
    const std::string before = file();
    EXPECT_EQ(history({"worse.json", "--dry-run"}).exitCode, 1);
    EXPECT_EQ(history({"worse.json", "--dry-run"}).exitCode, 1); // still a regression
    EXPECT_EQ(file(), before);
}

TEST_F(History, RepeatedResults_AreKeptOnce) {
    EXPECT_EQ(history({"base.json", "worse.json"}).exitCode, 1);
    EXPECT_EQ(history({"worse.json"}).exitCode, 1); // nothing is added, still a regression
    EXPECT_EQ(lines(), 2);
    EXPECT_EQ(history({"base.json"}).exitCode, 0); // fixed; added although FILE contains an equal record
    EXPECT_EQ(lines(), 3);
    const Outcome again = history({"base.json", "--label", "other"});
    EXPECT_THAT(again.out, HasSubstr("base.json: nothing new, it is record 3 ('plumbline 0.1.0')\n"));
    EXPECT_EQ(lines(), 3);
}

TEST_F(History, DamagedFile_IsUnchanged) {
    history({"base.json"});
    const std::string damaged = file() + "{\"schema\":1,\n";
    writeFile(folder_ / "h.jsonl", damaged);
    expectRefusal(history({"better.json"}), 2, "h.jsonl:2: is not valid JSON");
    EXPECT_EQ(file(), damaged);
    expectRefusal(run({"history", "base.json", "better.json"}), 2,
                  "base.json:1: is not valid JSON"); // arguments swapped
}

TEST_F(History, BadInput_LeavesFileUnchanged) {
    expectRefusal(history({}), 2, "h.jsonl: no such file");
    expectRefusal(history({"none.json"}), 2, "none.json: no such file");
    expectRefusal(history({"base.json", "none.json"}), 2, "none.json: no such file");
    expectRefusal(history({"base.json", "--label", ""}), 2, "--label");
    expectRefusal(history({"base.json", "--label", "two\nlines"}), 2, "--label");
    expectRefusal(history({"base.json", "--tolerance", "depth.rsme=1"}), 2, "did you mean 'depth.rmse'?");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "h.jsonl"));
    expectRefusal(run({"history"}), 2, "FILE");
    writeFile(folder_ / "h.jsonl", ""); // as touch leaves it
    EXPECT_EQ(history({"base.json"}).exitCode, 0);
    EXPECT_EQ(lines(), 1);
}

TEST_F(History, LastLineWithoutNewline_IsKept) {
    history({"base.json"});
    std::string text = file();
    text.pop_back();
    writeFile(folder_ / "h.jsonl", text);
    EXPECT_EQ(history({"better.json"}).exitCode, 0);
    EXPECT_EQ(lines(), 2);
}

} // namespace
} // namespace plumbline
