// Compares reference and renderer on flat bases, where the exact search of the shaders and the traced
// micro-triangles represent the same relief. Every pixel that differs must be marked uncertain in the
// reference.
#include "scenes/core/data_folder.h"
#include "scenes/scene/camera.h"
#include "scenes/scene_file/scene_file.h"
#include "tests/end_to_end/program.h"
#include "tests/read_frame.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::test {
namespace {

/// The extent of an object's plane at y = 0.
struct Rectangle {
    double lowX, highX, lowZ, highZ;
    bool holds(double x, double z) const { return x >= lowX && x <= highX && z >= lowZ && z <= highZ; }
};

/// By id - 1: planes of 1 x 7 centered at their translation (scenes/library/pyramid_plane.toml).
std::vector<Rectangle> rectanglesOf(const Scene& scene) {
    std::vector<Rectangle> rectangles;
    for (const SceneObject& object : scene.objects) {
        const Vec3& at = object.translate;
        rectangles.push_back({at.x - 0.5, at.x + 0.5, at.z - 3.5, at.z + 3.5});
    }
    return rectangles;
}

struct Tally {
    size_t compared = 0, otherObject = 0, otherDepth = 0, otherShadow = 0, lightCompared = 0;
    size_t unmarkedObject = 0, unmarkedDepth = 0, unmarkedShadow = 0;
};

class PlanarCrossCheck : public EndToEnd {
  protected:
    /// The scene of the library at 400 x 300.
    std::filesystem::path writeScene() const {
        std::string text = readFile(dataFolder() / "scenes" / "library" / "pyramid_plane.toml");
        text = withLine(text, "width = 800", "width = 400");
        text = withLine(text, "height = 600", "height = 300");
        const std::filesystem::path file = folder_ / "planes.toml";
        writeFile(file, text);
        return file;
    }
};

TEST_F(PlanarCrossCheck, ExactCells_EqualsReferenceWhereCertain) {
    const std::filesystem::path file = writeScene();
    // An exact search needs a shadow bias for rounding only: 1e-4 of the relief.
    const std::string technique = "exact_cells:shadow_bias=0.0001";
    const Outcome outcome = run({"validate", file.string(), "--technique", technique, "-o", "out"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Scene scene = readScene(file);
    const Frame truth = readFrame(folder_ / "out/frames/reference.exr");
    const Frame test = readFrame(folder_ / "out/frames" / "exact_cells_shadow_bias=0.0001.exr");
    const std::vector<Rectangle> rectangles = rectanglesOf(scene);
    const CameraRays rays(scene.camera);
    const Vec3 toLight = scene.lights[0].toLightWorld;

    const auto plane = [](const Frame& frame, const char* name) { return frame.channel(name); };
    const auto id = plane(truth, "id"), testId = plane(test, "id"), depth = plane(truth, "Z"),
               testDepth = plane(test, "Z"), shadow = plane(truth, "shadow.sun"),
               testShadow = plane(test, "shadow.sun"), uncertain = plane(truth, "uncertain"),
               uncertainShadow = plane(truth, "uncertain.shadow.sun"), x = plane(test, "P.X"),
               y = plane(test, "P.Y"), z = plane(test, "P.Z");
    Tally tally;
    for (size_t i = 0; i < truth.pixelCount(); ++i) {
        if (testId[i] == 0) continue;
        // The shader's relief continues beyond the edge of the polygon, the true one ends there. Only hits
        // before the edge are compared.
        const Rectangle& rectangle = rectangles[static_cast<size_t>(testId[i]) - 1];
        if (!rectangle.holds(x[i], z[i])) continue;
        ++tally.compared;
        const bool objectUncertain = uncertain[i] > 0,
                   sheetUncertain = objectUncertain || uncertainShadow[i] > 0;
        if (id[i] != testId[i]) {
            ++tally.otherObject;
            tally.unmarkedObject += !objectUncertain;
            continue;
        }
        // Refined hits of the reference lie on the surface to 1e-7; the shader computes in float. Depths
        // within 0.1 % of the relief are on the same sheet.
        if (std::abs(depth[i] - testDepth[i]) > 1e-3 * 0.12) {
            ++tally.otherDepth;
            tally.unmarkedDepth += !sheetUncertain;
            continue;
        }
        const Vec3 entry = Vec3(x[i], y[i], z[i]) - toLight * (static_cast<double>(y[i]) / toLight.y);
        if (!rectangle.holds(entry.x, entry.z)) continue; // the light ray passes relief that doesn't exist
        ++tally.lightCompared;
        if (shadow[i] == testShadow[i]) continue;
        ++tally.otherShadow;
        tally.unmarkedShadow += uncertainShadow[i] == 0;
    }
    fmt::print("{} pixels compared: other object {}, unmarked {}; other depth {}, unmarked {}; of {} the "
               "shadow in {}, unmarked {}\n",
               tally.compared, tally.otherObject, tally.unmarkedObject, tally.otherDepth, tally.unmarkedDepth,
               tally.lightCompared, tally.otherShadow, tally.unmarkedShadow);
    EXPECT_GT(tally.compared, 40000u);
    EXPECT_GT(tally.lightCompared, 30000u);
    EXPECT_EQ(tally.unmarkedObject, 0u);
    EXPECT_EQ(tally.unmarkedDepth, 0u);
    EXPECT_EQ(tally.unmarkedShadow, 0u);
}

} // namespace
} // namespace plumbline::test
