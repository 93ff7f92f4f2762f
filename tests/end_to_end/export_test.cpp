// Export of mesh and camera for other renderers, and import of their frames.
#include "scenes/image/exr_file.h"
#include "tests/end_to_end/program.h"
#include "tests/read_frame.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Export : public EndToEnd {
  protected:
    Outcome runReference(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"reference", writeSmallScene(), "--rate", "4"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    void expectRefused(const Outcome& outcome, const std::string& part) const {
        EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(part));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
};

TEST_F(Export, MeshAndCamera_AreWritten) {
    const Outcome outcome =
        runReference({"-o", "a.exr", "--export-mesh", "a.ply", "--export-camera", "a.json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(filesBelow(folder_), ElementsAre("a.exr", "a.json", "a.ply", "small.toml"));
    EXPECT_THAT(outcome.out, HasSubstr("triangles, "));
    EXPECT_EQ(nlohmann::json::parse(readFile(folder_ / "a.json"))["objects"][1]["name"], "floor");
    EXPECT_THAT(readFile(folder_ / "a.ply"), HasSubstr("comment object_id 2: floor\n"));
}

TEST_F(Export, BadNames_AreRefusedFirst) {
    expectRefused(runReference({"-o", "a.exr", "--export-mesh", "a.stl"}),
                  "a name that ends in .ply or .obj");
    expectRefused(runReference({"-o", "a.exr", "--export-mesh", "a.ply", "--export-camera", "./a.ply"}),
                  "is used for two results");
    expectRefused(runReference({"-o", "a.exr", "--export-camera", "small.toml"}), "would be overwritten");
    EXPECT_THAT(filesBelow(folder_), ElementsAre("small.toml"));
}

/// The reference's frame with Mitsuba's channel names and distances along the rays must compare equal.
TEST_F(Export, RenamedDistances_CompareEqual) {
    ASSERT_EQ(runReference({"-o", "a.exr"}).exitCode, 0);
    const Frame frame = readFrame(folder_ / "a.exr");
    std::map<std::string, std::vector<float>> planes;
    std::vector<float>& distance = planes["dist"];
    const Vec3 eye(1.1, 2.0, 2.9); // camera of the small scene
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel) {
        const Vec3 position(frame.channel("P.X")[pixel], frame.channel("P.Y")[pixel],
                            frame.channel("P.Z")[pixel]);
        distance.push_back(frame.channel("A")[pixel] > 0 ? float(glm::length(position - eye)) : 0.0f);
    }
    writeExr(folder_ / "b.exr", frame.width(), frame.height(), {{"dist", distance}}, {});
    const Outcome outcome = run({"compare", "a.exr", "b.exr", "--map", "dist=distance", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto technique = nlohmann::json::parse(outcome.out)["techniques"][0];
    EXPECT_EQ(technique["silhouette"]["iou"], 1.0);
    EXPECT_LT(technique["depth"]["max"], 1e-5); // rounding of floats of a few units
    EXPECT_THAT(technique["notes"].dump(), HasSubstr("dist is a distance along the ray"));
    EXPECT_THAT(technique["notes"].dump(), HasSubstr("no normal figures"));

    expectRefused(run({"compare", "a.exr", "b.exr"}), "no channel name is recognized; its channels are dist");
    expectRefused(run({"compare", "a.exr", "b.exr", "--map", "dist=depth"}), "no channel is called 'depth'");
    expectRefused(run({"compare", "b.exr", "b.exr", "--map", "dist=Z"}), "no channel name is recognized");
}

} // namespace
} // namespace plumbline::test
