// Techniques as data: techniques in user folders, and their errors.
#include "realtime/technique/technique.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/data_folder.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/realtime/gl_fixture.h"
#include "tests/temporary_folder.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

Scene bumpyScene() {
    const auto map = std::make_shared<HeightMap>(
        "bumps", 5, 3,
        std::vector<float>{0, 1, 0.3f, 0.7f, 1, 0.2f, 0, 0.9f, 0.4f, 0.1f, 1, 0, 0.5f, 0.8f, 0.6f});
    SceneObject object;
    object.name = "torus";
    object.mesh = makeTorus(1, 0.4, 12, 8);
    object.relief = Relief{map, 0.1, 0, Vec2(6, 4), Vec2(0)};
    Scene scene = sceneOf(object, Camera());
    scene.camera.positionWorld = Vec3(0.5, 1.5, 4);
    scene.camera.width = 96;
    scene.camera.height = 64;
    return scene;
}

bool sameBytes(const Frame& a, const Frame& b) {
    if (a.channelNames() != b.channelNames() || a.metadata != b.metadata) return false;
    for (const std::string& name : a.channelNames())
        if (std::memcmp(a.channel(name).data(), b.channel(name).data(), a.pixelCount() * sizeof(float)) != 0)
            return false;
    return true;
}

class UserTechnique : public testing::Test {
  protected:
    void SetUp() override {
        PLUMBLINE_NEEDS_GL(GlBackend::Auto);
        folder_ = std::make_unique<TemporaryFolder>();
    }
    void write(const std::string& shader) {
        writeFile(*folder_ / "mine/technique.toml",
                  "title = 'Mine'\ncitation = 'me'\ninputs = ['height']\nlimits = []\nneeds = []\n");
        writeFile(*folder_ / "mine/mine.glsl", shader);
    }
    std::string path() const { return (folder_->path() / "mine").string(); }
    /// The error message of drawing it; empty if it works.
    std::string message() const {
        return messageOf<InputError>([&] { draw(bumpyScene(), path()); });
    }
    std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(UserTechnique, CopiedFolder_DrawsEqualFrame) {
    const std::filesystem::path original = techniqueFolder("linear_binary");
    std::filesystem::copy(original, folder_->path() / "linear_binary");
    const std::string copy = (folder_->path() / "linear_binary").string();
    for (const char* rest : {"", "@quadric:linear_steps=33"})
        EXPECT_TRUE(sameBytes(draw(bumpyScene(), "linear_binary" + std::string(rest)),
                              draw(bumpyScene(), copy + rest)));
}

TEST_F(UserTechnique, CopiedTemplate_Runs) {
    const std::filesystem::path original = dataFolder() / "realtime" / "techniques" / "_template";
    std::filesystem::copy(original, folder_->path() / "mine");
    std::filesystem::rename(folder_->path() / "mine/_template.glsl", folder_->path() / "mine/mine.glsl");
    EXPECT_EQ(message(), "");
    EXPECT_EQ(resolveTechnique(path() + ":reach=0.5").name(), "mine:reach=0.5");
}

TEST_F(UserTechnique, CompileError_NamesFileAndLine) {
    write("// one\n// two\nReliefHit traceRelief(ReliefRay ray) { return nonsense; }\n");
    EXPECT_THAT(message(), HasSubstr(path() + "/mine.glsl:3: "));
    EXPECT_THAT(message(), HasSubstr("nonsense"));
    write("ReliefHit traceRelief(ReliefRay ray) {\n    return missed()\n}\n");
    EXPECT_THAT(message(), HasSubstr("/mine.glsl:3: "));
    write("ReliefHit traceRelief(ReliefRay ray) { return missed();\n\n"); // a missing brace
    EXPECT_THAT(message(), HasSubstr("/mine.glsl:"));
    write("\n#error boo\nReliefHit traceRelief(ReliefRay ray) { return missed(); }\n");
    EXPECT_THAT(message(), HasSubstr("/mine.glsl:2: "));
    EXPECT_THAT(message(), HasSubstr("boo"));
    // A redefinition of a harness function is reported at the author's line.
    write("\nvoid main() {}\nReliefHit traceRelief(ReliefRay ray) { return missed(); }\n");
    EXPECT_THAT(message(), HasSubstr("/mine.glsl:2: "));
}

TEST_F(UserTechnique, MissingEntryPoint_IsNamed) {
    write("float f(float x) { return x; }\n");
    EXPECT_EQ(message(),
              path() +
                  "/mine.glsl: doesn't define traceRelief; expected ReliefHit traceRelief(ReliefRay ray) "
                  "{ … }");
    write("ReliefHit traceRelief(ReliefRay ray, int i) { return missed(); }\n"); // an overload, so it doesn't
                                                                                 // link
    EXPECT_THAT(message(), HasSubstr("/mine.glsl"));
    EXPECT_THAT(message(), HasSubstr("traceRelief"));
}

TEST_F(UserTechnique, OwnUniform_IsRefused) {
    write("uniform float uMine;\nReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, uMine); }\n");
    EXPECT_EQ(message(), path() +
                             "/mine.glsl: declares uniform 'uMine', which the harness doesn't set; expected "
                             "parameters in technique.toml");
}

TEST_F(UserTechnique, UnreadBakedMap_IsRefused) {
    const auto writeShader = [&](const std::string& shader) {
        write(shader);
        writeFile(*folder_ / "mine/technique.toml",
                  "title = 'Mine'\ncitation = 'me'\ninputs = ['normal']\nlimits = []\n"
                  "needs = []\n");
    };
    writeShader("// normalAndDepth\nReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, 0.0); }\n");
    EXPECT_EQ(message(),
              path() + "/technique.toml: declares input 'normal', which the shader never reads; expected a "
                       "shader that calls a function of normal_map.glsl");
    // A lookup that is unused with the current settings still counts, although compilers eliminate it.
    writeShader(
        "ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, 0.0 * normalAndDepth(ray, ray.st).w); }\n");
    EXPECT_EQ(message(), "");
}

TEST_F(UserTechnique, NoTraceRelief_IsRefused) {
    write("// not written yet\n");
    EXPECT_THAT(message(), HasSubstr("doesn't define traceRelief"));
}

TEST_F(UserTechnique, MissEverywhere_CoversNothing) {
    write("ReliefHit traceRelief(ReliefRay ray) { return missed(); }\n");
    EXPECT_EQ(coveredPixels(draw(bumpyScene(), path())), 0u);
}

TEST_F(UserTechnique, AfterFailure_RendererWorks) {
    write("ReliefHit traceRelief(ReliefRay ray) { return nonsense; }\n");
    const Scene scene = bumpyScene();
    RealtimeRenderer renderer(scene, {GlBackend::Auto, -1, 0}, testContext());
    const Frame before = renderer.render(resolveTechnique("linear_binary"), nullptr).frame;
    EXPECT_THROW(renderer.render(resolveTechnique(path()), nullptr), InputError);
    EXPECT_THROW(renderer.render(resolveTechnique("micro_triangles"), nullptr), InputError);
    EXPECT_TRUE(sameBytes(before, renderer.render(resolveTechnique("linear_binary"), nullptr).frame));
}

// --- results -------------------------------------------------------------------------------------

TEST(TechniqueResult, Result_HasNameParametersAndTime) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Scene scene = bumpyScene();
    RealtimeRenderer renderer(scene, {}, testContext());
    const TechniqueResult result = renderer.render(
        resolveTechnique("linear_binary:linear_steps=20", {{"binary_steps", "4"}, {"cones", "1"}}), nullptr);
    EXPECT_EQ(result.name, "linear_binary:binary_steps=4,linear_steps=20");
    const std::map<std::string, std::string> expected{
        {"binary_steps", "4"},   {"depth_correction", "true"}, {"early_exit", "true"},
        {"filter", "exact"},     {"linear_steps", "20"},       {"shadow", "relief"},
        {"shadow_bias", "0.02"}, {"shadow_map_bias", "1"},     {"shadow_map_size", "1024"},
        {"steps", "fixed"},      {"tolerance", "0"},           {"triangle_bounds", "false"}};
    EXPECT_EQ(result.parameters, expected);
    EXPECT_EQ(result.frame.metadata.at("technique"), result.name);
    EXPECT_GT(result.msMedian, 0);
    EXPECT_GE(result.msRuns, 1);
    EXPECT_FALSE(result.timer.empty());
    EXPECT_FALSE(result.renderer.empty());
    // More steps cause more lookups; no pixel needs more than the maximum of both searches.
    float most = 0;
    for (const float fetches : result.frame.channel("cost.fetches"))
        most = std::max(most, fetches);
    EXPECT_LE(most, 2 * (20 + 4));
    EXPECT_GT(most, 20);
}

TEST(TechniqueResult, TwoRuns_GiveEqualBytes) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const char* technique : {"linear_binary", "linear_binary@quadric", "normal_mapping"})
        EXPECT_TRUE(sameBytes(draw(bumpyScene(), technique), draw(bumpyScene(), technique))) << technique;
}

TEST(TechniqueResult, EglAndOsmesa_GiveEqualBytes) {
    PLUMBLINE_NEEDS_GL(GlBackend::Egl);
    PLUMBLINE_NEEDS_GL(GlBackend::Osmesa);
    const Scene scene = bumpyScene();
    RealtimeRenderer egl(scene, {GlBackend::Egl, -1, 0}), osmesa(scene, {GlBackend::Osmesa, -1, 0});
    for (const char* technique : {"linear_binary", "linear_binary@quadric", "normal_mapping"}) {
        const TechniqueResult a = egl.render(resolveTechnique(technique), nullptr);
        const TechniqueResult b = osmesa.render(resolveTechnique(technique), nullptr);
        if (a.renderer != b.renderer) {
            GTEST_SKIP() << a.renderer << " and " << b.renderer << " are different rasterizers";
        }
        EXPECT_TRUE(sameBytes(a.frame, b.frame)) << technique;
    }
}

// --- limits of the machine -----------------------------------------------------------------------

TEST(Limits, TooManyLights_IsRefused) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = bumpyScene();
    scene.lights.clear();
    for (int i = 0; i < 16; ++i)
        scene.lights.push_back(directionalLight("l" + std::to_string(i), {std::cos(i), 1, std::sin(i)}));
    const Frame frame = draw(scene, "linear_binary");
    EXPECT_EQ(frame.lightNames().size(), 16u);
    // Each light has its own channel, which is the same if it is the only light.
    Scene alone = scene;
    alone.lights = {scene.lights[13]};
    const Frame one = draw(alone, "linear_binary");
    for (size_t i = 0; i < frame.pixelCount(); ++i)
        if (frame.channel("A")[i] > 0) {
            ASSERT_EQ(frame.channel("shadow.l13")[i], one.channel("shadow.l13")[i]);
        }
    scene.lights.push_back(directionalLight("one too many", {0, 1, 0}));
    EXPECT_EQ(messageOf<InputError>([&] { draw(scene, "linear_binary"); }),
              "light: the scene has 17 lights; expected at most 16 for real-time frames");
}

TEST(Limits, NoLight_Renders) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = bumpyScene();
    scene.lights.clear();
    for (const char* technique : {"linear_binary", "linear_binary@quadric"}) {
        const Frame frame = draw(scene, technique);
        EXPECT_TRUE(frame.lightNames().empty());
        EXPECT_GT(coveredPixels(frame), 500u);
    }
}

TEST(Limits, FrameAboveGlLimit_IsMachineError) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = bumpyScene();
    scene.camera.width = 1 << 20;
    EXPECT_THAT(messageOf<MachineError>([&] { draw(scene, "linear_binary"); }),
                testing::MatchesRegex(
                    "camera: a picture of 1048576 x 64 pixels; expected at most [0-9]+ x [0-9]+ on .*"));
}

TEST(Limits, HeightMapAboveGlLimit_IsMachineError) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = bumpyScene();
    scene.objects[0].relief->map =
        std::make_shared<HeightMap>("long", 1 << 20, 1, std::vector<float>(1 << 20, 0.5f));
    EXPECT_THAT(
        messageOf<MachineError>([&] { draw(scene, "linear_binary"); }),
        testing::MatchesRegex("long: a map of 1048576 x 1 texels; expected at most [0-9]+ a side on .*"));
}

TEST(Limits, NothingInView_IsAllBackground) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    Scene scene = bumpyScene();
    scene.camera.targetWorld = Vec3(1, 3, 8); // looks away
    EXPECT_EQ(coveredPixels(draw(scene, "linear_binary")), 0u);
    scene.objects.clear();
    EXPECT_EQ(coveredPixels(draw(scene, "linear_binary")), 0u);
}

} // namespace
} // namespace plumbline
