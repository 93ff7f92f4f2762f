// Both halves of the project against each other on curved bases. A quadric with its relief along the axis is
// exactly what the surface `quadric` takes the base of a fragment for, if the fragment is the quadric's apex.
// So the eye is put on the apex: every ray enters there, and the exact search and the traced micro-triangles
// see the same relief all around. Where they differ the reference must have said that it isn't sure.
#include "scenes/scene/camera.h"
#include "scenes/scene_file/scene_file.h"
#include "tests/end_to_end/program.h"
#include "tests/read_frame.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::test {
namespace {

constexpr double kReliefDepth = 0.2; // world units, like all lengths here
// The eye's height above the apex: 2e-5 of the relief. At a millionth of the farthest depth the near plane
// would cut the apex off.
constexpr double kHair = 4e-6;

struct Patch {
    const char* name;
    double a, b;     // z = a x^2 + b y^2
    double halfSize; // nearly all rays hit within it
    /// Largest error of depth that a hair explains, as a fraction of the relief's depth. The flattest ray has
    /// a sine of 0.2 and the proxy's facets around the apex fall away by up to 0.055, so a ray enters up to 7
    /// hairs from the apex. The base is off by up to a hair there, twice that along a ray; and its normal,
    /// along which the shader measures depth, is turned by 2 * curvature * 7 hairs: a place a relief's depth
    /// down moves sideways by that, on slopes of about 2.
    double tolerance() const {
        const double curvature = std::max(std::abs(a), std::abs(b)) * kReliefDepth;
        return (2 + 2 * 7 * 2 * curvature) * kHair / kReliefDepth;
    }
    friend void PrintTo(const Patch& patch, std::ostream* out) { *out << patch.name; }
};

class MouseEye : public EndToEnd, public testing::WithParamInterface<Patch> {
  protected:
    std::filesystem::path writeScene() const {
        // Straight down, so that the rays go all around and none is flatter than 12 degrees. Texel centers
        // fall on lattice vertices: with W = 64 texels a tile, st W - 1/2 is whole at the corners of the
        // faces.
        const Patch& patch = GetParam();
        const std::filesystem::path file = folder_ / "eye.toml";
        writeFile(file, fmt::format(R"(purpose = "A mouse's eye on the apex of a quadric"
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
relief = {{ map = "cobbles", depth = {}, tile = [{}, {}], uv_offset = [0.0546875, 0.0234375], along = "axis" }}
)",
                                    kHair, patch.a, patch.b, patch.halfSize, kReliefDepth, 4 * patch.halfSize,
                                    4 * patch.halfSize));
        return file;
    }
};

struct Tally {
    size_t compared = 0, marked = 0, outside = 0, covered = 0, otherCoverage = 0, otherDepth = 0;
    size_t unmarkedCoverage = 0, unmarkedDepth = 0;
    double largest = 0;
};

// Where a ray leaves the layer, d < 0, the shader gives up. Rightly: along a ray from above the apex the
// height above the base is a quadratic in t that starts at a hair and falls; if it is back at 0 it opens
// upwards and stays above, and nothing of the relief is above its base.
TEST_P(MouseEye, ExactCellsOnQuadric_EqualsReference) {
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
        // The shader's relief goes on beyond the patch, the true one ends there.
        if (testId[i] != 0 && std::max(std::abs(x[i]), std::abs(y[i])) > patch.halfSize) {
            ++tally.outside;
            continue;
        }
        ++tally.compared;
        tally.covered += testId[i] != 0;
        const bool unsure = uncertain[i] > 0, unsureOfSheet = unsure || uncertainShadow[i] > 0;
        tally.marked += unsureOfSheet;
        if (id[i] != testId[i]) {
            ++tally.otherCoverage;
            tally.unmarkedCoverage += !unsure;
            continue;
        }
        if (id[i] == 0) continue;
        const double error = std::abs(depth[i] - testDepth[i]) / kReliefDepth;
        if (error > patch.tolerance()) {
            ++tally.otherDepth;
            tally.unmarkedDepth += !unsureOfSheet;
        }
        if (!unsureOfSheet) tally.largest = std::max(tally.largest, error);
    }
    fmt::print("{}: {} pixels compared, {} covered, {} marked, {} beyond the patch; another coverage {}, "
               "unmarked {}; another depth {}, unmarked "
               "{}; largest unmarked error {:.1e} of the relief\n",
               patch.name, tally.compared, tally.covered, tally.marked, tally.outside, tally.otherCoverage,
               tally.unmarkedCoverage, tally.otherDepth, tally.unmarkedDepth, tally.largest);
    EXPECT_GT(tally.covered, 8000u);
    EXPECT_LT(tally.marked, tally.covered / 8);
    EXPECT_EQ(tally.unmarkedCoverage, 0u);
    EXPECT_EQ(tally.unmarkedDepth, 0u);
}

// Curvature times the relief's depth 0.02 and 0.5: hardly bent, and bent by half the relief's depth within
// its depth. Concave patches end before they rise to the eye's own height: contours that cross the camera's
// plane cost the reference half a minute.
INSTANTIATE_TEST_SUITE_P(
    Patches, MouseEye,
    testing::Values(Patch{"slightly_convex", -0.1, -0.1, 0.5}, Patch{"convex", -2.5, -2.5, 0.5},
                    Patch{"slightly_concave", 0.1, 0.1, 0.25}, Patch{"concave", 2.5, 2.5, 0.125},
                    Patch{"slight_cylinder", -0.1, 0, 0.5}, Patch{"cylinder", -2.5, 0, 0.5},
                    Patch{"slight_saddle", -0.1, 0.1, 0.5}, Patch{"saddle", -2.5, 2.5, 0.5}),
    [](const auto& patch) { return patch.param.name; });

} // namespace
} // namespace plumbline::test
