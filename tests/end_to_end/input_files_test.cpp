// Pipes, devices and folders in place of every kind of input: refused at once, never waited for.
#include "scenes/core/data_folder.h"
#include "scenes/frame/frame_exr.h"
#include "tests/end_to_end/program.h"
#include "tests/validate/metrics/painted_frames.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

class InputFiles : public EndToEnd {
  protected:
    InputFiles() {
        writeSmallScene();
        Frame frame = emptyFrame(4, 4);
        paintRectangle(frame, 1, 1, 3, 3);
        writeFrame(frame, folder_ / "good.exr");
        writeFile(folder_ / "square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 "
                                          "1\nf 1/1 2/2 3/3 4/4\n");
    }
    /// Runs the command for each kind of thing that `input` may be instead of a file.
    void expectRefused(const std::string& input, const std::vector<std::string>& arguments) const {
        const fs::path file = folder_ / input;
        fs::create_directories(file.parent_path());
        const std::pair<const char*, std::function<void()>> kinds[] = {
            {"pipe", [&] { ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0); }},
            {"folder", [&] { fs::create_directory(file); }},
            {"device", [&] { fs::create_symlink("/dev/zero", file); }}};
        for (const auto& [kind, make] : kinds) {
            fs::remove_all(file);
            make();
            // One that waits for another process is killed after two minutes.
            const Outcome outcome = run(arguments);
            EXPECT_EQ(outcome.signal, 0) << input << ", " << kind;
            EXPECT_EQ(outcome.exitCode, 2) << input << ", " << kind << ": " << outcome.err;
            EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
            EXPECT_THAT(outcome.err, Not(HasSubstr("internal error"))) << input << ", " << kind;
        }
        fs::remove_all(file);
    }
    void writeTechnique(const std::string& name) const {
        const fs::path from = dataFolder() / "realtime/techniques/_template";
        fs::create_directories(folder_ / name);
        fs::copy_file(from / "technique.toml", folder_ / name / "technique.toml");
        fs::copy_file(from / "_template.glsl", folder_ / name / (name + ".glsl"));
    }
};

TEST_F(InputFiles, NoRegularFile_IsRefusedAtOnce) {
    expectRefused("s.toml", {"reference", "s.toml", "-o", "out.exr"});
    expectRefused("s.toml", {"bake", "s.toml#stone", "--kind", "normal"});
    if (kProgramDraws) expectRefused("s.toml", {"study", "run", "s.toml", "-o", "out"});
    expectRefused("f.exr", {"compare", "f.exr", "good.exr"});
    expectRefused("f.exr", {"compare", "good.exr", "f.exr"});
    expectRefused("f.exr", {"bake", "f.exr", "--kind", "max_mipmap"});
    expectRefused("m.obj", {"new", "--mesh", "m.obj", "--height", "good.exr", "-o", "new.toml"});
    expectRefused("h.png", {"new", "--mesh", "square.obj", "--height", "h.png", "-o", "new.toml"});
    expectRefused("h.jsonl", {"history", "h.jsonl"});
    expectRefused("r.json", {"history", "good.jsonl", "r.json"});
    for (const char* option : {"m.obj", "h.png"}) {
        const bool mesh = std::string(option) == "m.obj";
        writeFile(folder_ / "s.toml",
                  withLine(kSmallScene,
                           mesh ? "shape = { kind = \"torus\", major = 1.0, minor = 0.4, segments = [12, 6] }"
                                : "generate = { kind = \"cobbles\", size = 32, seed = 1 }",
                           mesh ? "mesh = \"m.obj\"" : "file = \"h.png\"\nstores = \"depth\""));
        expectRefused(option, {"reference", "s.toml", "-o", "out.exr"});
    }
}

TEST_F(InputFiles, NoRegularTechnique_IsRefusedAtOnce) {
    if (!kProgramDraws) GTEST_SKIP() << "a build without OpenGL reads no technique";
    writeTechnique("mine");
    expectRefused("mine/technique.toml", {"realtime", "small.toml", "--technique", "./mine", "-o", "x.exr"});
    writeTechnique("other");
    expectRefused("other/other.glsl", {"realtime", "small.toml", "--technique", "./other", "-o", "x.exr"});
}

TEST_F(InputFiles, PipeInTheCache_IsBakedAgainWithAWarning) {
    const std::map<std::string, std::string> cache{{"PLUMBLINE_CACHE", (folder_ / "cache").string()}};
    const std::vector<std::string> bake{"bake", "small.toml#stone", "--kind", "max_mipmap"};
    ASSERT_EQ(run(bake, cache).exitCode, 0);
    const fs::path file = fs::directory_iterator(folder_ / "cache")->path();
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    const Outcome outcome = run(bake, cache);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("is not a file, it is a pipe"));
}

} // namespace
} // namespace plumbline
