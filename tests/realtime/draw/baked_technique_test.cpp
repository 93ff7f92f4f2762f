// Compares searches in baked maps with exact_cells, the ground truth on the same base.
#include "realtime/technique/technique.h"
#include "scenes/maps/generate_map.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/realtime/gl_fixture.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::HasSubstr;

constexpr double kDegree = 3.14159265358979323846 / 180;

std::shared_ptr<const HeightMap> generated(const std::string& kind, Wrap wrap = Wrap::Repeat, int size = 64) {
    return std::make_shared<HeightMap>(generateMap(kind, size, 3, wrap, wrap));
}

struct Oblique {
    std::string kind;
    double angleDegrees; // from the normal
    double depth;
    Vec2 tile;
    Wrap wrap = Wrap::Repeat;
};

/// A square of side 2 seen obliquely, so that every pixel of a covered row has a different ray through the
/// relief.
Scene sceneOf(const Oblique& view) {
    SceneObject object = squareObject(2, generated(view.kind, view.wrap), view.depth);
    object.relief->tile = view.tile;
    const double a = view.angleDegrees * kDegree;
    const Camera camera = orthographicCamera(5.0 * Vec3(-std::sin(a) * 0.8, std::cos(a), std::sin(a) * 0.6),
                                             {0, 1, 0.01}, 1.2, 96);
    return sceneOf(std::move(object), camera);
}

const std::vector<Oblique> kViews{{"cobbles", 0, 0.2, {1, 1}},
                                  {"cobbles", 50, 0.2, {2, 1}},
                                  {"bricks", 65, 0.1, {1, 3}},
                                  {"fins", 75, 0.1, {1, 1}},
                                  {"noise", 40, 0.5, {1, 1}, Wrap::Clamp},
                                  {"pins", 85, 0.05, {1, 2}}};

/// Of the pixels covered in either frame, those whose coverage differs, or whose depth differs by more than
/// `tolerance` relief depths.
struct Difference {
    size_t different = 0, pixels = 0;
    double share() const { return static_cast<double>(different) / static_cast<double>(pixels); }
};

Difference differenceOf(const Frame& a, const Frame& b, double reliefDepth, double tolerance) {
    Difference result;
    for (size_t i = 0; i < a.pixelCount(); ++i) {
        const bool inA = a.channel("A")[i] > 0, inB = b.channel("A")[i] > 0;
        if (!inA && !inB) continue;
        ++result.pixels;
        result.different +=
            inA != inB || std::abs(a.channel("Z")[i] - b.channel("Z")[i]) > tolerance * reliefDepth;
    }
    return result;
}

std::string named(const Oblique& view) {
    return view.kind + " at " + std::to_string(view.angleDegrees);
}

TEST(MaxMipmap, Hits_EqualExactCells) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const Oblique& view : kViews)
        for (const char* surface : {"", "@quadric"}) {
            const Scene scene = sceneOf(view);
            const Frame exact = draw(scene, std::string("exact_cells") + surface);
            const Frame found = draw(scene, std::string("max_mipmap") + surface);
            const Difference difference = differenceOf(exact, found, view.depth, 1e-4);
            EXPECT_GT(difference.pixels, 1000u);
            // Whether a ray hits an edge that it touches depends on the last bit, which differs between
            // blocks and cells.
            EXPECT_LE(difference.different, 3u) << named(view) << surface;
        }
}

TEST(MaxMipmap, FlatRelief_NeedsFewLookUps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Depth 1 except for one wall: a grazing ray crosses 60 cells but only a few blocks.
    std::vector<float> depths(128, 1);
    depths[5] = 0;
    Scene scene = sceneOf({"waves", 80, 0.3, {1, 1}});
    scene.objects[0].relief->map = std::make_shared<HeightMap>("wall", 128, 1, depths);
    const Frame exact = draw(scene, "exact_cells:shadow=none"),
                blocks = draw(scene, "max_mipmap:shadow=none");
    double cells = 0, both = 0, heights = 0;
    for (size_t i = 0; i < exact.pixelCount(); ++i) {
        cells += exact.channel("cost.fetches")[i];
        both += blocks.channel("cost.fetches")[i];
        heights += blocks.channel("cost.fetches.height")[i];
        ASSERT_EQ(blocks.channel("cost.fetches")[i],
                  blocks.channel("cost.fetches.height")[i] + blocks.channel("cost.fetches.baked")[i]);
    }
    EXPECT_LT(heights, 0.25 * cells);
    EXPECT_LT(both, cells);
}

TEST(ConeStepping, ManySteps_ConvergeToExactCells) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Each step reduces the remaining clearance by a factor; the search ends after 1000 steps or at a
    // clearance of 1e-3. Along a crest, a ray may pass within that clearance without an intersection and then
    // hits the crest.
    for (const Oblique& view : kViews)
        for (const char* technique :
             {"cone_step", "cone_step_quad", "cone_step@quadric", "cone_step_quad@quadric"}) {
            const Scene scene = sceneOf(view);
            const std::string surface =
                std::string(technique).find('@') == std::string::npos ? "" : "@quadric";
            const Frame exact = draw(scene, "exact_cells" + surface);
            const Frame found = draw(scene, std::string(technique) + ":cone_steps=1000,tolerance=0.001");
            const double slope = 1.0 / std::max(std::cos(view.angleDegrees * kDegree), 0.05);
            const Difference difference = differenceOf(exact, found, view.depth, 0.01 * slope);
            EXPECT_LE(difference.share(), 0.02) << named(view) << " " << technique;
        }
}

TEST(ConeStepping, AnyRay_NeverPassesFirstHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // For any number of steps, the result is in front of the first hit, never behind it.
    for (const Oblique& view : kViews)
        for (const char* technique :
             {"cone_step:cone_steps=5", "cone_step:cone_steps=40", "cone_step_quad:cone_steps=20"}) {
            const Scene scene = sceneOf(view);
            const Frame exact = draw(scene, "exact_cells"), found = draw(scene, technique);
            size_t behind = 0;
            for (size_t i = 0; i < exact.pixelCount(); ++i)
                behind += exact.channel("A")[i] > 0 &&
                          found.channel("Z")[i] > exact.channel("Z")[i] + 1e-4 * view.depth;
            EXPECT_LE(behind, 2u) << named(view) << " "
                                  << technique; // a ray that touches an edge, which the last bit decides
        }
}

TEST(RelaxedConeStepping, SafeMaps_FindFirstHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const Oblique& view : kViews)
        for (const char* refine : {"refine=binary,refine_steps=16", "refine=secant,refine_steps=16"}) {
            const Scene scene = sceneOf(view);
            const Frame exact = draw(scene, "exact_cells");
            const Frame found = draw(scene, std::string("cone_step_relaxed:cone_steps=400,") + refine);
            const Difference difference = differenceOf(exact, found, view.depth, 2e-3);
            EXPECT_LE(difference.share(), 0.003) << named(view) << " " << refine;
        }
}

TEST(RelaxedConeStepping, RelaxedCones_TakeFewerSteps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Scene scene = sceneOf(kViews[1]);
    const auto rounds = [&](const std::string& technique) {
        const Frame frame = draw(scene, technique);
        double sum = 0;
        for (const float count : frame.channel("cost.iterations"))
            sum += count;
        return sum;
    };
    // With cells a factor of 0.91, because the steepest slope in and around a cell bounds both ratios; with
    // texels 0.63.
    const std::string settings = "cone_steps=400,tolerance=0.001,cone_lookup=";
    EXPECT_LT(rounds("cone_step_relaxed:refine_steps=0," + settings + "cell"),
              rounds("cone_step:" + settings + "cell"));
    EXPECT_LT(rounds("cone_step_relaxed:refine_steps=0," + settings + "min_of_four"),
              0.7 * rounds("cone_step:" + settings + "min_of_four"));
}

TEST(SphereTracing, VoxelField_FindsFirstHit) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const Oblique& view : kViews) {
        const Scene scene = sceneOf(view);
        const Frame exact = draw(scene, "exact_cells");
        const Frame found = draw(scene, "sphere_tracing:sphere_steps=1000,binary_steps=16");
        // Near the relief the step is half a voxel, so thinner corners may be missed.
        const Difference difference = differenceOf(exact, found, view.depth, 2e-3);
        EXPECT_LE(difference.share(), 0.03) << named(view);
    }
}

TEST(SphereTracing, CurvedBase_IsRefusedWithReason) {
    EXPECT_THAT(
        messageOf<InputError>([] { (void)resolveTechnique("sphere_tracing@quadric"); }),
        HasSubstr("has no surface 'quadric': the search needs flat_base (a flat base, because distances "
                  "differ on a curved one)"));
}

TEST(BakedTechniques, Shadows_EqualExactCells) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Scene scene = sceneOf(kViews[1]);
    const Frame exact = draw(scene, "exact_cells");
    for (const char* technique :
         {"cone_step:cone_steps=1000,tolerance=0.001", "cone_step_relaxed:cone_steps=400,refine_steps=12",
          "max_mipmap", "sphere_tracing:sphere_steps=1000,binary_steps=12"}) {
        const Frame found = draw(scene, technique);
        size_t different = 0, shadowed = 0;
        for (size_t i = 0; i < exact.pixelCount(); ++i) {
            if (exact.channel("A")[i] == 0 || found.channel("A")[i] == 0) continue;
            different += exact.channel("shadow.sun")[i] != found.channel("shadow.sun")[i];
            shadowed += exact.channel("shadow.sun")[i] > 0;
        }
        EXPECT_GT(shadowed, 100u);
        EXPECT_LT(different, 100u) << technique; // at shadow edges, of 9216 pixels
    }
}

TEST(SlopeParallax, RampAtAnyScaleAndTile_IsExact) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // D is linear along s except at the map's border, so the plane through the point below the fragment is
    // the relief. A normal baked for one scale and used at another would give a wrong hit (TECHNIQUES E7).
    std::vector<float> depths;
    for (int i = 0; i < 64; ++i)
        depths.push_back(0.2f + 0.6f * static_cast<float>(i) / 63);
    const auto ramp = std::make_shared<HeightMap>("ramp", 64, 1, depths, Wrap::Clamp, Wrap::Repeat);
    for (const double depth : {0.05, 0.2, 0.6})
        for (const Vec2 tile : {Vec2(0.7, 1), Vec2(1, 3)}) {
            Scene scene = sceneOf(Oblique{"waves", 30, depth, tile});
            scene.objects[0].relief->map = ramp;
            const Frame exact = draw(scene, "exact_cells"), found = draw(scene, "parallax_slope_exact");
            size_t compared = 0;
            for (size_t i = 0; i < exact.pixelCount(); ++i) {
                if (exact.channel("A")[i] == 0) continue;
                const Vec2 st = stAt(exact, i);
                const double fragment =
                    st.x - depth * tile.x; // bound of the ray's start, also inside the ramp
                if (st.x < 0.05 || st.x > 0.95 || fragment < 0.05) continue;
                ++compared;
                ASSERT_NEAR(found.channel("Z")[i], exact.channel("Z")[i], 1e-4 * depth)
                    << depth << " " << tile.x << " " << st.x;
            }
            EXPECT_GT(compared, 300u) << depth << " " << tile.x;
        }
}

TEST(BakedInput, UnreadInput_IsRefused) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const TemporaryFolder folder;
    writeFile(folder / "mine/technique.toml",
              "title = 'Mine'\ncitation = 'me'\ninputs = ['height', 'cone_step']\nlimits = []\n"
              "needs = []\n");
    writeFile(folder / "mine/mine.glsl",
              "ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, reliefDepth(ray.st)); }\n");
    const std::string path = (folder.path() / "mine").string();
    EXPECT_THAT(messageOf<InputError>([&] { draw(sceneOf(kViews[0]), path); }),
                HasSubstr("technique.toml: declares input 'cone_step', which the shader never reads"));
    // If the input isn't declared, the function doesn't exist, and the compiler reports it at the author's
    // line.
    writeFile(folder / "mine/technique.toml",
              "title = 'Mine'\ncitation = 'me'\ninputs = ['height']\nlimits = []\nneeds = []\n");
    writeFile(folder / "mine/mine.glsl",
              "\nReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, coneOfCell(ray.st).r); }\n");
    EXPECT_THAT(messageOf<InputError>([&] { draw(sceneOf(kViews[0]), path); }), HasSubstr("mine.glsl:2: "));
}

} // namespace
} // namespace plumbline
