// Searches in baked maps against exact_cells, the perfect search on the same base.
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

/// A square of side 2 seen from the side, so that every pixel of a covered row has a ray of its own way
/// through the relief.
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

/// Pixels whose depth differs by more than `tolerance` relief depths, or whose coverage does, of those
/// covered by either.
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
            // A ray that touches an edge finds it or doesn't by the last bit, and blocks are entered at other
            // numbers than cells.
            EXPECT_LE(difference.different, 3u) << named(view) << surface;
        }
}

TEST(MaxMipmap, FlatRelief_NeedsFewLookUps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Depth 1 everywhere but for one wall: 60 cells to cross at a grazing angle, a few blocks.
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
    // Steps end short of the relief by a share that falls with each: 1000 steps or a clearance of 1e-3,
    // whichever comes first. Along a crest a ray may pass below that clearance without a hit: the error is
    // the crest's then.
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
    // Whatever the number of steps: short of the hit, never behind it.
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
                                  << technique; // a ray that touches an edge, decided by the last bit
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
    // By cells 0.91 of them: the steepest slope in and around a cell bounds both. By texels 0.63.
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
        // Half a voxel is the step near the relief: a corner thinner than that is passed through.
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
        EXPECT_LT(different, 100u) << technique; // along the shadows' edges, of 9216 pixels
    }
}

TEST(SlopeParallax, RampAtAnyScaleAndTile_IsExact) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // D grows linearly along s but for the map's border: the plane through the point under the fragment is
    // the relief itself. A normal baked at one scale and used at another would miss (TECHNIQUES E7).
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
                    st.x - depth * tile.x; // where the ray began, at the most: inside of the ramp as well
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
    // Without asking for it there is no such function, and the compiler says so in the author's line.
    writeFile(folder / "mine/technique.toml",
              "title = 'Mine'\ncitation = 'me'\ninputs = ['height']\nlimits = []\nneeds = []\n");
    writeFile(folder / "mine/mine.glsl",
              "\nReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, coneOfCell(ray.st).r); }\n");
    EXPECT_THAT(messageOf<InputError>([&] { draw(sceneOf(kViews[0]), path); }), HasSubstr("mine.glsl:2: "));
}

} // namespace
} // namespace plumbline
