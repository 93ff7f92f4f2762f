// Another renderer must draw the same image from the exported mesh and camera: Blender's Cycles, run by
// blender_frame.py.
#include "tests/end_to_end/program.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <gmock/gmock.h>

namespace plumbline::test {
namespace {

using ::testing::HasSubstr;

class BlenderFrame : public EndToEnd {
  protected:
    void SetUp() override {
        if (std::system("command -v blender > /dev/null") != 0)
            GTEST_SKIP() << "no blender on this machine (Debian: apt install blender python3-numpy)";
    }
    /// Blender's exit code, 124 if it takes longer than four minutes. Its output is in blender.log.
    int runBlender(const std::string& mesh, const std::string& camera, const std::string& out) const {
        const std::string command = "cd '" + folder_.string() +
                                    "' && timeout 240 blender -b -P '" PLUMBLINE_SOURCE_DIR
                                    "/tests/end_to_end/blender_frame.py' -- " +
                                    mesh + " " + camera + " " + out + " > blender.log 2>&1";
        return WEXITSTATUS(std::system(command.c_str()));
    }
};

TEST_F(BlenderFrame, ExportedMesh_CoversEqualPixels) {
    const Outcome reference = run({"reference", "stone_torus", "--rate", "64", "-o", "reference.exr",
                                   "--export-mesh", "mesh.ply", "--export-camera", "camera.json"});
    ASSERT_EQ(reference.exitCode, 0) << reference.err;
    ASSERT_EQ(runBlender("mesh.ply", "camera.json", "blender.exr"), 0) << readFile(folder_ / "blender.log");

    const Outcome compared = run({"compare", "reference.exr", "blender.exr", "--json"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    EXPECT_THAT(compared.out, HasSubstr("read as a frame of Blender"));
    const auto results = nlohmann::json::parse(compared.out);
    const auto& figures = results["techniques"][0];
    // Blender samples within 0.005 pixels of the center, so about ten pixels of a contour of some 2000 (of
    // 212 000 covered) may differ.
    EXPECT_GE(figures["silhouette"]["iou"], 0.9999);
    EXPECT_GT(figures["silhouette"]["reference_px"], 200000);
    // The reference's depth is that of the surface itself, Blender's that of micro-triangles at this distance
    // from it, along oblique rays. A distance interpreted as planar depth would have an error of 0.1 and
    // more.
    EXPECT_LT(figures["depth"]["p99"], 4 * results["reference"]["error_world_p99"].get<double>());
    EXPECT_LT(results["reference"]["error_world_p99"], 0.005);
    // Likewise; a micro-triangle is a texel wide.
    EXPECT_LT(figures["st"]["p95_texels"], 0.5);
}

TEST_F(BlenderFrame, ScriptWithoutMesh_IsRefused) {
    writeFile(folder_ / "mesh.ply", "ply\nformat ascii 1.0\n");
    writeFile(folder_ / "camera.json", "{}");
    EXPECT_NE(runBlender("mesh.ply", "camera.json", "blender.exr"), 0);
    EXPECT_THAT(filesBelow(folder_), testing::Not(testing::Contains("blender.exr")));
}

} // namespace
} // namespace plumbline::test
