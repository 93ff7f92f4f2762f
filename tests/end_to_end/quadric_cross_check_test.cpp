// Compares reference and renderer on curved bases. The surface `quadric` approximates the base of a fragment
// by a quadric. The approximation is exact if the base is a quadric displaced along its axis and the fragment
// is its apex. The eye is therefore placed at the apex, where every ray enters, so the exact search and the
// traced micro-triangles represent the same relief in all directions. Every pixel that differs must be marked
// uncertain in the reference.
#include "scenes/scene/camera.h"
#include "scenes/scene_file/scene_file.h"
#include "tests/end_to_end/program.h"
#include "tests/read_frame.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::test {
namespace {

constexpr double kReliefDepth = 0.2; // world units, like all lengths here
// 2e-5 of the relief above the apex. It can't be smaller, because the near plane, at a millionth of the
// farthest depth, would clip the apex.
constexpr double kEyeHeight = 4e-6;

struct Patch {
    const char* name;
    double a, b;     // z = a x^2 + b y^2
    double halfSize; // nearly all rays hit within it
    /// Largest depth error that the eye height h causes, as a fraction of the relief depth. The flattest ray
    /// has a sine of 0.2 and the proxy's facets around the apex slope down by up to 0.055, so a ray enters up
    /// to 7 h from the apex. There the base has an error of up to h, twice that along a ray. Its normal,
    /// along which the shader measures depth, is rotated by 2 * curvature * 7 h, which moves a point one
    /// relief depth below sideways by that angle, on slopes of about 2.
    double tolerance() const {
        const double curvature = std::max(std::abs(a), std::abs(b)) * kReliefDepth;
        return (2 + 2 * 7 * 2 * curvature) * kEyeHeight / kReliefDepth;
    }
    friend void PrintTo(const Patch& patch, std::ostream* out) { *out << patch.name; }
};

class QuadricCrossCheck : public EndToEnd, public testing::WithParamInterface<Patch> {
  protected:
    std::filesystem::path writeScene() const {
        // Looks straight down, so that rays go in all directions and none is flatter than 12 degrees. Texel
        // centers coincide with lattice vertices: with W = 64 texels per tile, st W - 1/2 is an integer at
        // the corners of the faces. Away from the apex of a convex patch the eye is behind the polygons but
        // above the relief, so their back sides aren't drawn.
        const Patch& patch = GetParam();
        const std::filesystem::path file = folder_ / "eye.toml";
        writeFile(file, fmt::format(R"(purpose = "An eye at the apex of a quadric"
[camera]
position = [0, 0, {}]
target = [0, 0, -1]
fov_y_degrees = 140
width = 300
height = 225
[[light]]
name = "sun"
to_light = [0, 0, 1]
[[height_map]]
name = "cobbles"
generate = {{ kind = "cobbles", size = 64, seed = 1 }}
[[object]]
name = "patch"
shape = {{ kind = "quadric", a = {}, b = {}, half_size = {}, segments = 4 }}
proxy_rate = 16
cull = "back"
relief = {{ map = "cobbles", depth = {}, tile = [{}, {}], uv_offset = [0.0546875, 0.0234375], along = "axis" }}
)",
                                    kEyeHeight, patch.a, patch.b, patch.halfSize, kReliefDepth,
                                    4 * patch.halfSize, 4 * patch.halfSize));
        return file;
    }
};

struct Tally {
    size_t compared = 0, marked = 0, outside = 0, covered = 0, otherCoverage = 0, otherDepth = 0;
    size_t unmarkedCoverage = 0, unmarkedDepth = 0;
    double largest = 0;
};

// Where a ray leaves the layer (d < 0), the shader reports a miss. This is correct: along a ray from above
// the apex the height above the base is a quadratic function of t that starts at the eye height and
// decreases. If it returns to 0, it opens upwards and stays positive, and no part of the relief is above its
// base.
TEST_P(QuadricCrossCheck, ExactCellsOnQuadric_EqualsReference) {
    const Patch& patch = GetParam();
    const std::filesystem::path file = writeScene();
    const Outcome outcome =
        run({"validate", file.string(), "--technique", "exact_cells@quadric", "--rate", "256", "-o", "out"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Frame truth = readFrame(folder_ / "out/frames/reference.exr");
    const Frame test = readFrame(folder_ / "out/frames/exact_cells-on-quadric.exr");
    const auto id = truth.channel("id"), testId = test.channel("id"), depth = truth.channel("Z"),
               testDepth = test.channel("Z"), uncertain = truth.channel("uncertain"),
               uncertainShadow = truth.channel("uncertain.shadow.sun"), x = test.channel("P.X"),
               y = test.channel("P.Y");
    Tally tally;
    for (size_t i = 0; i < truth.pixelCount(); ++i) {
        // The shader's relief continues beyond the patch, the true one ends there.
        if (testId[i] != 0 && std::max(std::abs(x[i]), std::abs(y[i])) > patch.halfSize) {
            ++tally.outside;
            continue;
        }
        ++tally.compared;
        tally.covered += testId[i] != 0;
        const bool objectUncertain = uncertain[i] > 0,
                   sheetUncertain = objectUncertain || uncertainShadow[i] > 0;
        tally.marked += sheetUncertain;
        if (id[i] != testId[i]) {
            ++tally.otherCoverage;
            tally.unmarkedCoverage += !objectUncertain;
            continue;
        }
        if (id[i] == 0) continue;
        const double error = std::abs(depth[i] - testDepth[i]) / kReliefDepth;
        if (error > patch.tolerance()) {
            ++tally.otherDepth;
            tally.unmarkedDepth += !sheetUncertain;
        }
        if (!sheetUncertain) tally.largest = std::max(tally.largest, error);
    }
    fmt::print("{}: {} pixels compared, {} covered, {} marked, {} beyond the patch; other coverage {}, "
               "unmarked {}; other depth {}, unmarked "
               "{}; largest unmarked error {:.1e} of the relief\n",
               patch.name, tally.compared, tally.covered, tally.marked, tally.outside, tally.otherCoverage,
               tally.unmarkedCoverage, tally.otherDepth, tally.unmarkedDepth, tally.largest);
    EXPECT_GT(tally.covered, 8000u);
    EXPECT_LT(tally.marked, tally.covered / 8);
    EXPECT_EQ(tally.unmarkedCoverage, 0u);
    EXPECT_EQ(tally.unmarkedDepth, 0u);
}

// Curvature times relief depth is 0.02 (nearly flat) or 0.5. Concave patches end before they reach the height
// of the eye, because contours that cross the camera plane cost the reference half a minute.
INSTANTIATE_TEST_SUITE_P(
    Patches, QuadricCrossCheck,
    testing::Values(Patch{"slightly_convex", -0.1, -0.1, 0.5}, Patch{"convex", -2.5, -2.5, 0.5},
                    Patch{"slightly_concave", 0.1, 0.1, 0.25}, Patch{"concave", 2.5, 2.5, 0.125},
                    Patch{"slight_cylinder", -0.1, 0, 0.5}, Patch{"cylinder", -2.5, 0, 0.5},
                    Patch{"slight_saddle", -0.1, 0.1, 0.5}, Patch{"saddle", -2.5, 2.5, 0.5}),
    [](const auto& patch) { return patch.param.name; });

} // namespace
} // namespace plumbline::test
