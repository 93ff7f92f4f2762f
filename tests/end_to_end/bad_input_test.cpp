// Mistakes in a scene, a mesh, an image or a frame: exit code 2, one line on stderr, no files left.
#include "scenes/frame/frame_exr.h"
#include "tests/end_to_end/program.h"
#include "tests/validate/metrics/painted_frames.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class BadInput : public EndToEnd {
  protected:
    /// Runs the reference on a scene of this text and expects an error that contains `part` and no files.
    void expectSceneRefused(const std::string& text, const std::string& part) const {
        writeFile(folder_ / "scene.toml", text);
        const auto before = filesBelow(folder_);
        expectRefused(run({"reference", "scene.toml", "--rate", "4", "-o", "out/frame.exr"}), part);
        EXPECT_EQ(filesBelow(folder_), before) << part;
    }
    void expectLineRefused(const std::string& line, const std::string& replacement,
                           const std::string& part) const {
        expectSceneRefused(withLine(kSmallScene, line, replacement), part);
    }
    /// Replaces the torus of the small scene by a mesh file of this text, without subdivision.
    void expectMeshRefused(const std::string& obj, const std::string& part) const {
        writeFile(folder_ / "mesh.obj", obj);
        expectLineRefused("shape = { kind = \"torus\", major = 1.0, minor = 0.4, segments = [12, 6] }",
                          "mesh = \"mesh.obj\"", part);
    }
    void expectImageRefused(const std::string& file, const std::string& part) const {
        expectLineRefused("generate = { kind = \"cobbles\", size = 32, seed = 1 }",
                          "file = \"" + file + "\"\nstores = \"depth\"", part);
    }
    static void expectRefused(const Outcome& outcome, const std::string& part) {
        EXPECT_EQ(outcome.signal, 0) << "crashed: " << part;
        EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(part));
        EXPECT_THAT(outcome.err, Not(HasSubstr("internal error")));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_THAT(outcome.out, IsEmpty());
    }
};

TEST_F(BadInput, UndamagedScene_Works) {
    const std::string scene = writeSmallScene();
    EXPECT_EQ(run({"reference", scene, "--rate", "4", "-o", "out/frame.exr"}).exitCode, 0);
}

TEST_F(BadInput, BadScenes_AreRefused) {
    expectRefused(run({"reference", "missing.toml"}), "missing.toml");
    expectRefused(run({"reference", "."}), "");
    expectRefused(run({"reference", "stone_toruss"}), "did you mean 'stone_torus'?");
    const std::string text = kSmallScene;
    expectSceneRefused(text.substr(0, text.find("minor") + 8), "scene.toml:");          // truncated
    expectSceneRefused("", "scene.toml");                                               // empty
    expectSceneRefused(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "scene.toml"); // an image
    expectSceneRefused(text + std::string(1, '\0'), "scene.toml");
    expectLineRefused("fov_y_degrees = 40", "fov_y_degres = 40",
                      "fov_y_degrees"); // unknown key, with a suggestion
    expectLineRefused("purpose = ", "porpoise = 1\npurpose = ", "porpoise");
    expectLineRefused("fov_y_degrees = 40", "fov_y_degrees = nan", "fov_y_degrees");
    expectLineRefused("fov_y_degrees = 40", "fov_y_degrees = \"wide\"", "fov_y_degrees");
    expectLineRefused("fov_y_degrees = 40", "fov_y_degrees = 180", "fov_y_degrees");
    expectLineRefused("position = [1.1, 2.0, 2.9]", "position = [1.1, inf, 2.9]", "position");
    expectLineRefused("position = [1.1, 2.0, 2.9]", "position = [0, -0.12, 0]",
                      "target"); // no view direction
    expectLineRefused("to_light = [-0.7, 0.6, 0.5]", "to_light = [0, 0, 0]", "to_light");
    expectLineRefused("depth = 0.1", "depth = -1", "depth");
    expectLineRefused("map = \"stone\"", "map = \"wood\"", "wood");
}

TEST_F(BadInput, HugeSizes_AreRefused) {
    for (const char* width : {"1000000000", "1e9", "0", "-5", "9223372036854775807"})
        expectLineRefused("width = 96", "width = " + std::string(width), "width");
    expectLineRefused("size = 32", "size = 1000000000", "size");
    expectLineRefused("segments = [12, 6]", "segments = [1000000000, 6]", "segments");
    expectLineRefused("proxy_rate = 2", "proxy_rate = 1000000000", "proxy_rate");
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST_F(BadInput, BadMeshes_AreRefused) {
    const std::string square = kSquare;
    expectLineRefused("shape = { kind = \"torus\", major = 1.0, minor = 0.4, segments = [12, 6] }",
                      "mesh = \"missing.obj\"", "missing.obj");
    expectMeshRefused("", "mesh.obj");
    expectMeshRefused(square, "mesh.obj");                           // truncated: no face
    expectMeshRefused(square + "f 1/1 2/2 3/3 9/4\n", "mesh.obj:9"); // index out of range
    expectMeshRefused(square + "f 1/1 2/2 3/3 4/9\n", "mesh.obj:9");
    expectMeshRefused(square + "f 0/1 2/2 3/3 4/4\n", "mesh.obj:9");
    expectMeshRefused(square + "f 1/1 2/2\n", "mesh.obj:9"); // truncated
    expectMeshRefused(square + "f 1 2 3 4\n", "uv");         // a relief needs uvs
    expectMeshRefused(withLine(square, "v 1 0 -1", "v 1 nan -1") + "f 1/1 2/2 3/3 4/4\n", "mesh.obj:3");
    expectMeshRefused("v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n", "area");
    expectMeshRefused(std::string("\x7f"
                                  "ELF\0\0\1\2",
                                  8),
                      "mesh.obj");
}

TEST_F(BadInput, BadImages_AreRefused) {
    expectImageRefused("missing.png", "missing.png");
    writeFile(folder_ / "text.png", "this is no picture\n");
    expectImageRefused("text.png", "text.png");
    writeFile(folder_ / "cut.png",
              std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10\0\0\0\x10\x08\0\0\0\0", 29));
    expectImageRefused("cut.png", "cut.png");
    writeFile(folder_ / "empty.exr", "");
    expectImageRefused("empty.exr", "empty.exr");
    Frame notANumber(2, 2);
    notANumber.add("R");
    notANumber.add("G");
    notANumber.add("B");
    notANumber.channel("R")[1] = notANumber.channel("G")[1] = notANumber.channel("B")[1] = kNanF;
    writeFrame(notANumber, folder_ / "nan.exr");
    expectImageRefused("nan.exr", "nan.exr");
}

TEST_F(BadInput, BadFrames_AreRefused) {
    Frame good = emptyFrame(8, 8);
    paintRectangle(good, 1, 1, 5, 5);
    writeFrame(good, folder_ / "good.exr");
    const std::string bytes = readFile(folder_ / "good.exr");
    const auto expectFrameRefused = [&](const std::string& file, const std::string& part) {
        const auto before = filesBelow(folder_);
        expectRefused(run({"compare", "good.exr", file, "-o", "out"}), part);
        EXPECT_EQ(filesBelow(folder_), before) << file;
    };
    expectFrameRefused("missing.exr", "missing.exr");
    writeFile(folder_ / "cut.exr", bytes.substr(0, bytes.size() - 100));
    expectFrameRefused("cut.exr", "cut.exr");
    writeFile(folder_ / "head.exr", bytes.substr(0, 200));
    expectFrameRefused("head.exr", "head.exr");
    writeFile(folder_ / "text.exr", "hello\n");
    expectFrameRefused("text.exr", "text.exr");
    writeFile(folder_ / "empty.exr", "");
    expectFrameRefused("empty.exr", "empty.exr");
    writeFrame(emptyFrame(8, 9), folder_ / "taller.exr");
    expectFrameRefused("taller.exr", "8 x 9");
    Frame blind(8, 8);
    blind.add("R"); // Z would define its coverage
    writeFrame(blind, folder_ / "blind.exr");
    expectFrameRefused("blind.exr", "channel A");
    Frame odd = good;
    set(odd, "id", 3, 2, 0.5f);
    writeFrame(odd, folder_ / "odd.exr");
    expectFrameRefused("odd.exr", "pixel (3, 2)");
    Frame lying = good;
    lying.metadata["program"] = "plumbline 0.1.0";
    lying.metadata["object.1.relief_depth"] = "deep";
    writeFrame(lying, folder_ / "lying.exr");
    expectFrameRefused("lying.exr", "relief_depth");
    expectRefused(run({"compare", ".", "good.exr"}), ".");
}

// Permissions don't restrict root, so a regular file in place of the folder is used instead.
TEST_F(BadInput, UnwritableOutput_IsRefused) {
    const std::string scene = writeSmallScene();
    Frame frame = emptyFrame(2, 2);
    paintPixel(frame, 0, 0, 1, 2);
    writeFrame(frame, folder_ / "frame.exr");
    const auto before = filesBelow(folder_);
    expectRefused(run({"reference", scene, "--rate", "4", "-o", "small.toml/frame.exr"}), "small.toml");
    expectRefused(run({"reference", scene, "--rate", "4", "-o", "."}), "folder");
    expectRefused(run({"reference", scene, "--rate", "4", "-o", "/dev/full"}), "/dev/full");
    expectRefused(run({"compare", "frame.exr", "frame.exr", "-o", "small.toml/out"}), "small.toml");
    EXPECT_EQ(filesBelow(folder_), before);
}

} // namespace
} // namespace plumbline
