// plumbline new: it writes a scene file that works.
#include "scenes/frame/frame_exr.h"
#include "scenes/scene_file/scene_file.h"
#include "tests/end_to_end/program.h"
#include "tests/read_frame.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A curved sheet of 2 x 2 quads with uvs.
const char* const kSheet =
    "v -1 0 1\nv 0 0.2 1\nv 1 0 1\nv -1 0.2 0\nv 0 0.5 0\nv 1 0.2 0\nv -1 0 -1\nv 0 0.2 -1\nv 1 0 -1\n"
    "vt 0 0\nvt 0.5 0\nvt 1 0\nvt 0 0.5\nvt 0.5 0.5\nvt 1 0.5\nvt 0 1\nvt 0.5 1\nvt 1 1\n"
    "f 1/1 2/2 5/5 4/4\nf 2/2 3/3 6/6 5/5\nf 4/4 5/5 8/8 7/7\nf 5/5 6/6 9/9 8/8\n";

class New : public EndToEnd {
  protected:
    void SetUp() override {
        writeFile(folder_ / "sheet.obj", kSheet);
        // A height map that needs neither OpenImageIO nor shared data.
        Frame map(16, 16);
        for (const char* channel : {"R", "G", "B"}) {
            const std::span<float> values = map.add(channel);
            for (size_t i = 0; i < values.size(); ++i)
                values[i] = static_cast<float>(i % 16) / 15.0f;
        }
        writeFrame(map, folder_ / "waves.exr");
    }

    Outcome make(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"new",       "--mesh", "sheet.obj", "--height",
                                           "waves.exr", "-o",     "scene.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    /// For a small image: the share of covered pixels, and whether the border is free.
    void expectFramed(const std::string& scene, int width, int height) const {
        const Outcome drawn =
            run({"reference", scene, "--scene-set", "camera.width=" + std::to_string(width), "--scene-set",
                 "camera.height=" + std::to_string(height), "--memory", "16M", "-o", "frame.exr"});
        ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
        const Frame frame = readFrame(folder_ / "frame.exr");
        const std::span<const float> coverage = frame.channel("A");
        size_t covered = 0, atBorder = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (coverage[static_cast<size_t>(y * width + x)] > 0) {
                    ++covered;
                    atBorder += x == 0 || y == 0 || x + 1 == width || y + 1 == height;
                }
        EXPECT_EQ(atBorder, 0u);
        EXPECT_GT(static_cast<double>(covered), 0.15 * width * height);
        EXPECT_LT(static_cast<double>(covered), 0.8 * width * height);
    }
};

TEST_F(New, MeshAndMap_GiveRunningScene) {
    const Outcome made = make();
    EXPECT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(made.out, "scene.toml\nnext: plumbline validate scene.toml\n");
    EXPECT_EQ(made.err, "");
    EXPECT_THAT(filesBelow(folder_), ElementsAre("scene.toml", "sheet.obj", "waves.exr"));
    EXPECT_THAT(readFile(folder_ / "scene.toml"), HasSubstr("file = \"waves.exr\""));
    expectFramed("scene.toml", 80, 60);
}

TEST_F(New, OutputInOtherFolder_FindsFiles) {
    EXPECT_EQ(run({"new", "--mesh", "sheet.obj", "--height", (folder_ / "waves.exr").string(), "-o",
                   "a/b/scene.toml"})
                  .exitCode,
              0);
    const std::string text = readFile(folder_ / "a/b/scene.toml");
    EXPECT_THAT(text, HasSubstr("mesh = \"../../sheet.obj\""));
    EXPECT_THAT(text, HasSubstr("file = \"../../waves.exr\""));
    EXPECT_NO_THROW(readScene(folder_ / "a/b/scene.toml"));
}

TEST_F(New, Spot_IsFramed) {
    const std::filesystem::path spot = std::filesystem::path(PLUMBLINE_SHARED_DATA) / "spot_control_mesh.obj";
    if (!std::filesystem::exists(spot)) GTEST_SKIP() << "no " << spot;
    EXPECT_EQ(run({"new", "--mesh", spot.string(), "--height", "waves.exr", "-o", "spot.toml"}).exitCode, 0);
    expectFramed("spot.toml", 60, 80);
}

TEST_F(New, ExistingFile_IsKept) {
    writeFile(folder_ / "scene.toml", "mine");
    expectRefusal(make(), 2, "scene.toml: exists already; expected a new name; --force replaces it");
    EXPECT_EQ(readFile(folder_ / "scene.toml"), "mine");
    EXPECT_EQ(make({"--force"}).exitCode, 0);
    EXPECT_NO_THROW(readScene(folder_ / "scene.toml"));
}

TEST_F(New, UnusableInput_IsRefusedWithoutFile) {
    expectRefusal(run({"new", "--mesh", "sheet.obj", "--height", "none.png", "-o", "x/s.toml"}), 2,
                  "none.png: no such file");
    expectRefusal(run({"new", "--mesh", "none.obj", "--height", "waves.exr", "-o", "x/s.toml"}), 2,
                  "none.obj: no such file");
    expectRefusal(run({"new", "--mesh", "waves.exr", "--height", "waves.exr", "-o", "x/s.toml"}), 2,
                  "waves.exr");
    expectRefusal(run({"new", "--mesh", "sheet.obj", "--height", "waves.exr", "-o", "sheet.obj"}), 2,
                  "FILE.toml");
    expectRefusal(run({"new", "--mesh", "sheet.obj", "-o", "x/s.toml"}), 2, "--height is required");
    for (const char* bad : {"0", "-1", "nan", "1e10", "deep"})
        expectRefusal(make({"--depth", bad}), 2, "--depth");
    for (const char* bad : {"0,1", "1", "1,2,3", "inf,1", ",", "1e7,1"})
        expectRefusal(make({"--tile", bad}), 2, "--tile");
    expectRefusal(make({"--scheme", "lop"}), 2, "did you mean 'loop'?");
    expectRefusal(make({"--scheme", "loop"}), 2, "sheet.obj:19: face 1: 4 vertices; expected only triangles");
    expectRefusal(make({"--stores", "heigth"}), 2, "did you mean 'height'?");
    expectRefusal(make({"--wrap", "repeat"}), 2, "--wrap");
    writeFile(folder_ / "bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectRefusal(run({"new", "--mesh", "bare.obj", "--height", "waves.exr", "-o", "x/s.toml"}), 2,
                  "bare.obj: has no uvs");
    EXPECT_THAT(filesBelow(folder_), ElementsAre("bare.obj", "sheet.obj", "waves.exr"));
}

TEST_F(New, OddNames_AreAccepted) {
    const std::string name = "a \"b\" \\ c\n#[x]";
    writeFile(folder_ / (name + ".obj"), kSheet);
    EXPECT_EQ(run({"new", "--mesh", name + ".obj", "--height", "waves.exr", "-o", "scene.toml"}).exitCode, 0);
    EXPECT_EQ(readScene(folder_ / "scene.toml").objects[0].name, "a__b____c___x_");
    writeFile(folder_ / "bad\xff.obj", kSheet);
    expectRefusal(run({"new", "--mesh", "bad\xff.obj", "--height", "waves.exr", "-o", "other.toml"}), 2,
                  "UTF-8");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "other.toml"));
}

TEST_F(New, OddMesh_IsReported) {
    writeFile(folder_ / "sheet.obj", std::string(kSheet) + "v 5 5 5\n");
    const Outcome made = make();
    EXPECT_EQ(made.exitCode, 0);
    EXPECT_THAT(made.err, HasSubstr("warning: sheet: "));
}

} // namespace
} // namespace plumbline
