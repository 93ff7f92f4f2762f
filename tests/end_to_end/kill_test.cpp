// Every command that writes is killed with SIGKILL at random times and run again: what was finished stays,
// the next run succeeds, and nothing is left over after it. PLUMBLINE_KILLS is how often.
#include "tests/end_to_end/program.h"
#include "tests/validate/results/sample_results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

namespace plumbline {
namespace {

using namespace test;
namespace fs = std::filesystem;

constexpr int kKills = PLUMBLINE_KILLS;

bool isRunsOwn(const std::string& file) {
    return file.find(".plumbline-") != std::string::npos;
}

class Kill : public EndToEnd {
  protected:
    using Files = std::map<std::string, std::string>; // contents by path

    /// Finished results below a folder: what must not change or vanish.
    Files finished(const std::string& folder, const std::string& ending) const {
        Files files;
        for (const std::string& file : filesBelow(folder_ / folder))
            if (file.ends_with(ending) && !isRunsOwn(file)) files[file] = readFile(folder_ / folder / file);
        return files;
    }

    double secondsOf(const std::vector<std::string>& arguments) const {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(run(arguments, kEnvironment).exitCode, 0);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    /// Kills a run at a random time within `seconds`. True if it was killed before its end.
    bool kill(const std::vector<std::string>& arguments, double seconds) {
        const Running running = startProgram(arguments, folder_, kEnvironment);
        std::this_thread::sleep_for(
            std::chrono::duration<double>(std::uniform_real_distribution<double>(0, seconds)(random_)));
        const std::vector<pid_t> children = childrenOf(running.process);
        sendSignal(running.process, SIGKILL);
        const Outcome outcome = finish(running);
        for (const pid_t child : children)
            EXPECT_TRUE(waitUntil([&] { return isGone(child); }, 10)) << "a child outlives its parent";
        EXPECT_TRUE(outcome.signal == SIGKILL || outcome.exitCode == 0) << outcome.err;
        return outcome.signal == SIGKILL;
    }

    void expectNothingLeftOver() const {
        for (const std::string& file : filesBelow(folder_))
            EXPECT_FALSE(isRunsOwn(file)) << file;
    }

    void report(const char* command, int kills, int finishedCases) const {
        fmt::print("{}: {} kills, {} finished results stayed\n", command, kills, finishedCases);
    }

    const std::map<std::string, std::string> kEnvironment{{"PLUMBLINE_CACHE", (folder_ / "cache").string()}};
    std::mt19937 random_{16}; // the times vary with the machine all the same
};

TEST_F(Kill, Study_LosesNoFinishedCase) {
    writeSmallScene();
    std::string depths = "0.01";
    for (int i = 2; i <= 12; ++i)
        depths += fmt::format(", {}", 0.01 * i);
    writeFile(folder_ / "tiny.toml", fmt::format(R"(title = "Tiny"
purpose = "For kills"
memory = "64M"
[[grid]]
name = "main"
scenes = ["small.toml"]
scene_set = ["camera.height=36", "camera.width=48"]
[[grid.axis]]
name = "depth"
field = "object.torus.relief.depth"
values = [{}]
[[grid.technique]]
label = "linear"
name = "linear:linear_steps=4"
)",
                                                 depths));
    const std::vector<std::string> study{"study", "run", "tiny.toml", "-o", "out"};
    const double seconds = 0.7 * secondsOf(study); // several kills until all cases are done
    int stayed = 0;
    for (int kills = 0; kills < kKills;) {
        const Files before = finished("out/cases", ".json");
        if (before.size() == 12) fs::remove_all(folder_ / "out");
        kills += kill(study, seconds);
        const Files after = finished("out/cases", ".json");
        for (const auto& [file, text] : after)
            EXPECT_TRUE(nlohmann::json::accept(text)) << file;
        if (before.size() == 12) continue;
        for (const auto& [file, text] : before)
            EXPECT_EQ(after.contains(file) ? after.at(file) : "lost", text) << file;
        stayed += static_cast<int>(before.size());
    }
    EXPECT_EQ(run(study, kEnvironment).exitCode, 0);
    EXPECT_EQ(finished("out/cases", ".json").size(), 12u);
    expectNothingLeftOver();
    report("study", kKills, stayed);
}

TEST_F(Kill, Validate_LeavesWholeFiles) {
    writeSmallScene();
    const std::vector<std::string> validate{"validate",    "small.toml",   "--rate",      "4",
                                            "-o",          "out",          "--technique", "linear",
                                            "--technique", "linear_binary"};
    const double seconds = secondsOf(validate);
    const size_t files = filesBelow(folder_ / "out").size();
    for (int kills = 0; kills < kKills;) {
        kills += kill(validate, seconds);
        for (const auto& [file, text] : finished("out", "results.json"))
            EXPECT_TRUE(nlohmann::json::accept(text)) << file;
        for (const auto& [file, text] : finished("out", "index.html"))
            EXPECT_NE(text.find("</html>"), std::string::npos) << file;
    }
    EXPECT_EQ(run(validate, kEnvironment).exitCode, 0);
    EXPECT_EQ(filesBelow(folder_ / "out").size(), files);
    expectNothingLeftOver();
    report("validate", kKills, 0);
}

TEST_F(Kill, Bake_IsMadeAgain) {
    writeSmallScene();
    const std::vector<std::string> bake{"bake", "small.toml#stone", "--kind", "cone_step",
                                        "-o",   "out/map.exr"};
    const double seconds = secondsOf(bake);
    const std::string whole = readFile(folder_ / "out/map.exr");
    for (int kills = 0; kills < kKills;) {
        fs::remove_all(folder_ / "cache");
        kills += kill(bake, seconds);
        EXPECT_EQ(readFile(folder_ / "out/map.exr"), whole); // that of an earlier run, or of this one
    }
    const Outcome again = run(bake, kEnvironment);
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_EQ(again.err, ""); // no map in the cache is damaged
    expectNothingLeftOver();
    report("bake", kKills, kKills);
}

TEST_F(Kill, History_LosesNoRecord) {
    const auto resultsOf = [&](int number) {
        Results results = sampleResults();
        results.scene.name = fmt::format("scene{}", number);
        writeFile(folder_ / "r.json", toJson(results));
    };
    const std::vector<std::string> history{"history", "h.jsonl", "r.json"};
    resultsOf(0);
    const double seconds = secondsOf(history);
    int number = 1;
    for (int kills = 0; kills < kKills; ++number) {
        resultsOf(number);
        const std::string before = readFile(folder_ / "h.jsonl");
        const bool killed = kill(history, seconds);
        kills += killed;
        const std::string after = readFile(folder_ / "h.jsonl");
        EXPECT_TRUE(after.starts_with(before));
        EXPECT_TRUE(after.ends_with('\n'));
        EXPECT_TRUE(killed || after.size() > before.size()) << "exit code 0 without the record";
        EXPECT_EQ(run(history, kEnvironment).exitCode, 0);
    }
    const std::string text = readFile(folder_ / "h.jsonl");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), number); // those of every run, each once
    expectNothingLeftOver();
    report("history", kKills, number);
}

} // namespace
} // namespace plumbline
