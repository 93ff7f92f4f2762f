// Compares GLSL functions with their C++ versions and with closed forms.
#include "realtime/technique/stage_sources.h"
#include "realtime/technique/technique_list.h"
#include "tests/realtime/draw/evaluate_glsl.h"
#include "tests/realtime/gl_fixture.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace plumbline {
namespace {

constexpr double kFloatEpsilon = 0x1p-23;

HeightMap randomMap(int width, int height, Wrap wrapS, Wrap wrapT, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> depth(0, 1);
    std::vector<float> depths(static_cast<size_t>(width) * static_cast<size_t>(height));
    for (float& d : depths)
        d = depth(random);
    return HeightMap("random", width, height, std::move(depths), wrapS, wrapT);
}

/// Inside, outside, negative, on texel centers, on texel borders, on seams.
std::vector<glm::vec4> coordinates(const HeightMap& map, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> anywhere(-3, 4);
    std::uniform_int_distribution<int> texel(-2 * map.width(), 3 * map.width());
    std::vector<glm::vec4> points{
        {0, 0, 0, 0}, {1, 1, 0, 0}, {-1, -1, 0, 0}, {0, 1, 0, 0}, {-1e-9f, -1e-9f, 0, 0}};
    for (int i = 0; i < 1000; ++i) {
        points.emplace_back(anywhere(random), anywhere(random), 0, 0);
        points.emplace_back((static_cast<float>(texel(random)) + 0.5f) / static_cast<float>(map.width()),
                            static_cast<float>(texel(random)) / static_cast<float>(map.height()), 0, 0);
    }
    return points;
}

/// Depth in x, its gradient in y and z, by GLSL.
std::vector<glm::vec4> lookUp(const HeightMap& map, const std::vector<glm::vec4>& points, bool hardware) {
    const CurrentContext current(*testContext());
    ShaderSource source;
    source.addText("(settings)",
                   hardware ? "const bool kHardwareFilter = true;" : "const bool kHardwareFilter = false;");
    source.addFile(harnessShader("height_map.glsl"));
    source.addText("(test)",
                   "vec4 evaluate(vec4 a) { return vec4(reliefDepth(a.xy), reliefDepthGradient(a.xy), "
                   "float(gHeightLookups)); }");
    GlTexture texture = GlTexture::make();
    return evaluateGlsl(source, points, [&](const GlProgram& program) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture.get());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map.width(), map.height(), 0, GL_RED, GL_FLOAT,
                     map.depths().data());
        const auto mode = [](Wrap wrap) { return wrap == Wrap::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; };
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, mode(map.wrapS()));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, mode(map.wrapT()));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glUniform1i(program.uniform("uHeightMap"), 0);
        glUniform2i(program.uniform("uHeightMapClamps"), map.wrapS() == Wrap::Clamp,
                    map.wrapT() == Wrap::Clamp);
    });
}

struct MapCase {
    int width, height;
    Wrap wrapS, wrapT;
};

class LookUp : public testing::TestWithParam<MapCase> {
  protected:
    void compare(bool hardware) {
        PLUMBLINE_NEEDS_GL(GlBackend::Auto);
        const auto [width, height, wrapS, wrapT] = GetParam();
        const HeightMap map = randomMap(width, height, wrapS, wrapT, 7);
        const std::vector<glm::vec4> points = coordinates(map, 11);
        const std::vector<glm::vec4> found = lookUp(map, points, hardware);
        // The texel position st * size - 0.5 has a few rounding errors of magnitude size, in texels, and
        // adjacent depths differ by up to 1 along each axis. Interpolation adds a few rounding errors below
        // 1. Samplers of GPUs may round the weights to 8 bits: half of 1/256 along each axis.
        const double tolerance =
            4 * kFloatEpsilon * (width + height) + (hardware ? 2.0 / 512 : 0) + 4 * kFloatEpsilon;
        double largest = 0;
        for (size_t i = 0; i < points.size(); ++i) {
            const double expected = map.depth(Vec2(points[i].x, points[i].y));
            EXPECT_NEAR(found[i].x, expected, tolerance) << points[i].x << " " << points[i].y;
            EXPECT_EQ(found[i].w, 1.0f); // counted once
            largest = std::max(largest, std::abs(found[i].x - expected));
        }
        RecordProperty("largest_error", std::to_string(largest));
        if (!hardware) compareGradients(map, points, found);
    }

    void compareGradients(const HeightMap& map, const std::vector<glm::vec4>& points,
                          const std::vector<glm::vec4>& found) {
        for (size_t i = 0; i < points.size(); ++i) {
            // At a crease the float may be on the other side, so the gradients of both sides are valid.
            const double s = points[i].x * map.width() - 0.5, t = points[i].y * map.height() - 0.5;
            if (std::abs(s - std::round(s)) < 1e-3 || std::abs(t - std::round(t)) < 1e-3) continue;
            const Vec2 expected = map.sample(Vec2(points[i].x, points[i].y)).gradient;
            const double size = map.width() + map.height();
            EXPECT_NEAR(found[i].y, expected.x, 8 * kFloatEpsilon * size * size);
            EXPECT_NEAR(found[i].z, expected.y, 8 * kFloatEpsilon * size * size);
        }
    }
};

TEST_P(LookUp, ExactBilinear_EqualsCpp) {
    compare(false);
}

TEST_P(LookUp, HardwareFilter_EqualsCppToItsWeights) {
    compare(true);
}

INSTANTIATE_TEST_SUITE_P(
    Maps, LookUp,
    testing::Values(MapCase{1, 1, Wrap::Repeat, Wrap::Repeat}, MapCase{1, 1, Wrap::Clamp, Wrap::Clamp},
                    MapCase{37, 23, Wrap::Repeat, Wrap::Repeat}, MapCase{64, 16, Wrap::Clamp, Wrap::Repeat},
                    MapCase{5, 300, Wrap::Repeat, Wrap::Clamp}, MapCase{2, 2, Wrap::Clamp, Wrap::Clamp}));

TEST(LookUpOfNonsense, NonFiniteSt_StaysInsideMap) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const HeightMap map = randomMap(8, 8, Wrap::Repeat, Wrap::Repeat, 1);
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    // There is no correct result, but the lookup must not read outside the texture.
    EXPECT_EQ(lookUp(map,
                     {{infinity, 0, 0, 0}, {0, -infinity, 0, 0}, {nan, nan, 0, 0}, {1e30f, -1e30f, 0, 0}},
                     false)
                  .size(),
              4u);
}

// --- the end of the search interval over a quadric -----------------------------------------------

std::vector<glm::vec4> searchEnds(const std::vector<glm::vec4>& descentAndF) {
    const CurrentContext current(*testContext());
    ShaderSource source;
    source.addText("(settings)", "const bool kHardwareFilter = false;\nconst bool kFromBehind = false;");
    source.addFile(harnessShader("height_map.glsl"));
    source.addFile(harnessShader("relief_contract.glsl"));
    source.addFile(harnessShader("relief_side.glsl"));
    source.addFile(harnessShader("quadric_base.glsl"));
    source.addFile(surfacesFolder() / "quadric" / "quadric.glsl");
    source.addText("(test)",
                   "vec4 evaluate(vec4 a) {\n"
                   "  vec2 end = searchEnd(a.x, a.y);\n"
                   "  ReliefRay ray = ReliefRay(vec2(0.0), vec2(0.0), end.y, a.y * end.x * end.x, end.x, "
                   "1.0, vec2(1.0), 1.0, vec4(0.0), vec4(0.0));\n"
                   "  return vec4(end, surfacePosition(ray, 1.0).z, surfacePosition(ray, 0.5).z);\n}");
    return evaluateGlsl(source, descentAndF);
}

TEST(SearchEnd, Erratum16_ExamplesAreRight) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The textbook root gives 1.192, 0 and NaN for these (float32, v_d = 1); the interval ends where d = 1,
    // at tau = 1.
    const auto ends = searchEnds({{1, 1e-7f, 0, 0}, {1, 1e-9f, 0, 0}, {1, 0, 0, 0}, {1, -1e-9f, 0, 0}});
    for (const glm::vec4& end : ends) {
        EXPECT_NEAR(end.x, 1, 2 * kFloatEpsilon);
        EXPECT_EQ(end.y, 1);
    }
    // Regression: t0 = v_d / f = 133 was truncated at a sentinel of 100.
    const auto far = searchEnds({{133, 1e5f, 0, 0}});
    EXPECT_NEAR(far[0].x, 133 / 1e5, 1e-9);
    EXPECT_EQ(far[0].y, 0);
}

TEST(SearchEnd, EveryCurvature_EndsAtFirstRoot) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    std::vector<glm::vec4> arguments;
    for (const float descent : {1e-3f, 0.1f, 1.0f, 7.0f, 1e3f}) {
        arguments.emplace_back(descent, 0, 0, 0);
        for (float magnitude = 1e-12f; magnitude <= 1.1e2f; magnitude *= 3)
            for (const float sign : {-1.0f, 1.0f})
                arguments.emplace_back(descent, sign * magnitude, 0, 0);
    }
    const std::vector<glm::vec4> ends = searchEnds(arguments);
    for (size_t i = 0; i < arguments.size(); ++i) {
        const double v = arguments[i].x, f = arguments[i].y, tau = ends[i].x, discriminant = v * v - 4 * f;
        // Within rounding of a double root either end would be correct; none of the cases is that close.
        ASSERT_GT(std::abs(discriminant), 16 * kFloatEpsilon * v * v);
        SCOPED_TRACE(testing::Message() << "v_d " << v << " f " << f);
        ASSERT_TRUE(std::isfinite(tau));
        EXPECT_GT(tau, 0);
        // d(tau) = v tau - f tau^2 must be the depth reported. tau has a few rounding errors, and the
        // discriminant one of v^2, which its square root magnifies by v / sqrt(discriminant); d changes by at
        // most v + 2 |f| tau per unit of tau.
        const double relative =
            4 * kFloatEpsilon * (1 + (discriminant > 0 ? v / std::sqrt(discriminant) : 0));
        EXPECT_NEAR(v * tau - f * tau * tau, ends[i].y, relative * tau * (v + 2 * std::abs(f) * tau));
        EXPECT_EQ(ends[i].y, discriminant >= 0 ? 1 : 0);
        // Exactly the end depth at t = 1, so that a floor at depth 1 is hit; and the parabola in between.
        EXPECT_EQ(ends[i].z, ends[i].y);
        EXPECT_NEAR(ends[i].w, 0.5 * tau * v - 0.25 * f * tau * tau,
                    8 * kFloatEpsilon * tau * (v + std::abs(f) * tau) * (1 + relative / kFloatEpsilon));
        // The first: both roots are positive only if f > 0, and then d rises up to tau = v / (2 f).
        if (f > 0 && discriminant > 0) {
            EXPECT_LE(tau, v / (2 * f) * (1 + 1e-6));
        }
    }
}

} // namespace
} // namespace plumbline
