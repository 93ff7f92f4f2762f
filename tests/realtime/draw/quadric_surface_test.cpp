// Compares the depth below a quadric in GLSL with a double-precision computation from the definition, which
// uses the quadric as a surface in space and none of the shaders' formulas.
#include "realtime/technique/stage_sources.h"
#include "tests/realtime/draw/evaluate_glsl.h"
#include "tests/realtime/gl_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace plumbline {
namespace {

constexpr double kFloatEpsilon = 0x1p-23;
constexpr std::array kAllQuadrics{"quadric_full", "quadric_perpendicular", "quadric_nearest"};

/// A ray from a point of the base into the relief. Space: X along the tangent of s, Z along the outward
/// normal.
struct Case {
    double a = 0, b = 0, c = 0;
    double tangentCosine = 0; // between the tangents of s and t
    double sine = 0, azimuth = 0;
    double depth = 1; // of the relief
    Vec2 scale{1};
    double cosine() const { return std::sqrt(1 - sine * sine); }
    Vec3 ray() const { return {sine * std::cos(azimuth), sine * std::sin(azimuth), -cosine()}; }
    double tangentSine() const { return std::sqrt(1 - tangentCosine * tangentCosine); }
    /// Oblique coordinates along the unit tangents.
    Vec2 oblique(double x, double y) const {
        return {x - tangentCosine / tangentSine() * y, y / tangentSine()};
    }
    double base(double x, double y) const {
        const Vec2 p = oblique(x, y);
        return -(a * p.x * p.x + c * p.x * p.y + b * p.y * p.y);
    }
    /// Height's second derivative in a direction: curvature of the base there is -2 k.
    double along(const Vec2& way) const { return -base(way.x, way.y); }
};

double depthAlongNormal(const Case& at, const Vec3& point) {
    return at.base(point.x, point.y) - point.z;
}

/// RP-351 Eqs 3 to 6; NaN where there is no such point.
double depthPerpendicular(const Case& at, const Vec3& point, const Vec3& ray) {
    const Vec3 normal(0, 0, 1), up = glm::normalize(normal - glm::dot(normal, ray) * ray);
    const auto outside = [&](double sigma) { return -depthAlongNormal(at, point + sigma * up); };
    // A quadratic in sigma, determined from three values.
    const double c = outside(0), a = 0.5 * (outside(1) + outside(-1)) - c,
                 b = 0.5 * (outside(1) - outside(-1));
    if (std::abs(a) < 1e-14) return -c / b;
    const double discriminant = b * b - 4 * a * c;
    return discriminant < 0 ? NAN : 2 * -c / (b + std::sqrt(discriminant));
}

struct Foot {
    Vec2 place{0};
    double distance = 0;
};

/// Nearest point of the base and signed distance, by a search with decreasing step size; positive inside.
Foot nearestByTrying(const Case& at, const Vec3& point) {
    const double inside = depthAlongNormal(at, point);
    Vec2 best(point.x, point.y);
    double least = inside * inside;
    for (double reach = std::abs(inside); reach > 1e-9 * at.depth; reach *= 0.4) {
        const Vec2 center = best;
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j) {
                const Vec2 place = center + Vec2(i, j) * (reach / 4);
                const Vec3 offset = Vec3(place, at.base(place.x, place.y)) - point;
                if (const double squared = glm::dot(offset, offset); squared < least) {
                    least = squared;
                    best = place;
                }
            }
    }
    return {best, std::copysign(std::sqrt(least), inside)};
}

/// The world distance that a surface defines as depth, at `tau` along the ray.
double trueDepth(const std::string& surface, const Case& at, double tau) {
    const Vec3 point = tau * at.ray();
    if (surface.starts_with("quadric_nearest")) return nearestByTrying(at, point).distance;
    if (surface == "quadric_perpendicular")
        if (const double depth = depthPerpendicular(at, point, at.ray()); std::isfinite(depth)) return depth;
    return depthAlongNormal(at, point);
}

/// GLSL source of a surface. `texel` n of a case's column: curvature and tangentCosine; (s, t, d) per world
/// unit; scales and depth.
ShaderSource surfaceSource(const std::string& surface, const std::string& evaluate) {
    const Technique technique = resolveTechnique("linear_binary@" + surface);
    ShaderSource source;
    source.addText(
        "(settings)",
        "const bool kHardwareFilter = false;\nconst bool kFromBehind = false;\nuniform sampler2D uCases;");
    source.addFile(harnessShader("height_map.glsl"));
    source.addFile(harnessShader("relief_contract.glsl"));
    source.addFile(harnessShader("relief_side.glsl"));
    source.addFile(harnessShader("quadric_base.glsl"));
    source.addText("(parameters)", technique.glslConstants());
    source.addFile(technique.surface->shaderFile());
    source.addText(
        "(test)",
        "vec4 texel(vec4 a, int n) { return texelFetch(uCases, ivec2(int(a.x), n), 0); }\n"
        "ReliefFrame frameOf(vec4 a) {\n"
        "  vec4 curvature = texel(a, 0), scale = texel(a, 2);\n"
        "  float sine = sqrt(1.0 - curvature.w * curvature.w);\n"
        "  return ReliefFrame(vec3(0.0, 0.0, 1.0), vec3(scale.x, 0.0, 0.0),\n"
        "                     scale.y * vec3(curvature.w, sine, 0.0), vec2(0.0), curvature.xyz, scale.z);\n"
        "}\n" +
            evaluate);
    return source;
}

std::vector<glm::vec4> evaluateCases(const std::string& surface, const std::vector<Case>& cases,
                                     const std::vector<double>& t, const std::string& evaluate) {
    const CurrentContext current(*testContext());
    std::vector<glm::vec4> texels(3 * cases.size()), arguments;
    for (size_t i = 0; i < cases.size(); ++i) {
        const Case& at = cases[i];
        const Vec2 way = at.oblique(at.ray().x, at.ray().y) / at.scale;
        texels[i] = glm::vec4(at.a, at.b, at.c, at.tangentCosine);
        texels[cases.size() + i] = glm::vec4(way, at.cosine() / at.depth, 0);
        texels[2 * cases.size() + i] = glm::vec4(at.scale, at.depth, 0);
        arguments.emplace_back(static_cast<float>(i), static_cast<float>(t[i]), 0, 0);
    }
    const GlTexture texture = GlTexture::make();
    return evaluateGlsl(surfaceSource(surface, evaluate), arguments, [&](const GlProgram& program) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture.get());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(cases.size()), 3, 0, GL_RGBA,
                     GL_FLOAT, texels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glUniform1i(program.uniform("uCases"), 0);
    });
}

/// At the given t: d, length in world units, depth at the end; with `st`, st in zw.
constexpr const char* kPosition =
    "vec4 evaluate(vec4 a) {\n"
    "  ReliefRay ray;\n"
    "  bool enters = enterRelief(frameOf(a), vec2(0.0), texel(a, 1).xyz, ray);\n"
    "  return vec4(surfacePosition(ray, a.y).z, ray.lengthWorld, ray.endDepth, "
    "surfaceDescent(ray, a.y));\n}";
constexpr const char* kTexture = "vec4 evaluate(vec4 a) {\n"
                                 "  ReliefRay ray;\n"
                                 "  bool enters = enterRelief(frameOf(a), vec2(0.0), texel(a, 1).xyz, ray);\n"
                                 "  return vec4(surfacePosition(ray, a.y).xy, ray.stTravel);\n}";

double radians(double degrees) {
    return degrees * kPi / 180;
}

Case planar(double degrees, double a) {
    Case at;
    at.a = a;
    at.sine = std::sin(radians(degrees));
    return at;
}

TEST(QuadricDepth, KnownTable_IsReproduced) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // The table of realtime/README.md, a = 0.25, tau = 0.1: angle from the normal, D_z, D_U, D_n, rounded.
    const struct {
        double degrees, vertical, perpendicular, nearest;
    } table[] = {{1, .1000, .597, .1000},
                 {30, .0860, .156, .0859},
                 {45, .0695, .0934, .0694},
                 {75, .0235, .0241, .0235}};
    for (const auto& row : table) {
        SCOPED_TRACE(row.degrees);
        const Case at = planar(row.degrees, 0.25);
        const double expected[] = {row.vertical, row.perpendicular, row.nearest};
        for (size_t i = 0; i < 3; ++i) {
            const std::string surface = kAllQuadrics[i];
            EXPECT_NEAR(trueDepth(surface, at, 0.1), expected[i], expected[i] < 0.1005 ? 5e-5 : 5e-4)
                << surface;
            const double length = evaluateCases(surface, {at}, {0}, kPosition)[0].y;
            EXPECT_NEAR(evaluateCases(surface, {at}, {0.1 / length}, kPosition)[0].x,
                        trueDepth(surface, at, 0.1), 1e-6)
                << surface;
        }
    }
    // One point and three directions: only D_U depends on the direction.
    const Vec3 point(.3, 0, -.15);
    for (const auto& [degrees, expected] :
         {std::pair(10.0, .320), std::pair(40.0, .163), std::pair(70.0, .128)})
        EXPECT_NEAR(depthPerpendicular(planar(degrees, .25), point, planar(degrees, .25).ray()), expected,
                    5.1e-4);
    EXPECT_NEAR(depthAlongNormal(planar(10, .25), point), .1275, 1e-12);
    EXPECT_NEAR(nearestByTrying(planar(10, .25), point).distance, .1260, 5.1e-5);
    // Over a concave base, Eq. 7 replaces Eq. 6 from tau = s^2 / (-4 a c) on, where the depth jumps from s (1
    // - s^2 / 2) / (-2 a c^2) to s^2 / (-4 a) (1 + s^4 / (4 c^2)).
    const Case concave = planar(20, -.25);
    const double turn = concave.sine * concave.sine / concave.cosine();
    EXPECT_NEAR(trueDepth("quadric_perpendicular", concave, turn * (1 - 1e-9)), .7293, 1e-3);
    EXPECT_NEAR(trueDepth("quadric_perpendicular", concave, turn * (1 + 1e-9)), .1174, 1e-4);
    const double length = evaluateCases("quadric_perpendicular", {concave}, {0}, kPosition)[0].y;
    const auto beside = evaluateCases("quadric_perpendicular", {concave, concave},
                                      {0.999 * turn / length, 1.001 * turn / length}, kPosition);
    EXPECT_NEAR(beside[0].x, trueDepth("quadric_perpendicular", concave, 0.999 * turn), 1e-4);
    EXPECT_NEAR(beside[1].x, trueDepth("quadric_perpendicular", concave, 1.001 * turn), 1e-6);
}

/// Curvatures of either sign, tangents up to 45 degrees from orthogonal, any direction, reliefs as deep as up
/// to a quarter of the smallest radius of curvature.
std::vector<Case> randomCases(size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> sign(-1, 1), unit(0, 1);
    std::vector<Case> cases(count);
    for (Case& at : cases) {
        at = {0.25 * sign(random), 0.25 * sign(random), 0.25 * sign(random), 0.7 * sign(random)};
        at.sine = 0.01 + 0.989 * unit(random);
        at.azimuth = 2 * kPi * unit(random);
        at.scale = Vec2(std::exp(2 * sign(random)), std::exp(2 * sign(random)));
        // Oblique coordinates are up to 1.8 times the orthogonal ones' length: no curvature exceeds 2 * 0.375
        // * 1.8^2 * 2.
        at.depth = 0.25 / 4.9 * std::exp(2 * unit(random) - 2);
    }
    return cases;
}

TEST(QuadricDepth, RandomQuadrics_EqualCpp) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const std::vector<Case> cases = randomCases(4000, 5);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> t(cases.size());
    for (double& value : t)
        value = unit(random);
    for (const std::string surface : kAllQuadrics) {
        const auto found = evaluateCases(surface, cases, t, kPosition);
        const auto a = evaluateCases(surface, cases, t, kTexture);
        size_t compared = 0;
        for (size_t i = 0; i < cases.size(); ++i) {
            const Case& at = cases[i];
            const double tau = t[i] * found[i].y;
            const Vec3 ray = at.ray();
            const double k = at.along(Vec2(ray.x, ray.y)) / (at.sine * at.sine);
            // D_U's root is ill-conditioned where its discriminant passes through 0.
            const double discriminant = at.sine * at.sine + 4 * k * at.cosine() * tau;
            if (surface == "quadric_perpendicular" && std::abs(discriminant) < 0.01 * at.sine * at.sine)
                continue;
            ++compared;
            // All depths are differences of tau c and k s^2 tau^2 divided by sz, with about a dozen rounding
            // errors of the larger term, which D_U's division by sine and root magnifies.
            const double terms = tau * (at.cosine() + std::abs(k) * at.sine * at.sine * tau) / at.depth;
            const double magnified =
                surface == "quadric_perpendicular" && discriminant > 0 ? 2 / std::sqrt(discriminant) : 1;
            const double tolerance = 32 * kFloatEpsilon * terms * std::max(1.0, magnified) + 1e-6;
            SCOPED_TRACE(testing::Message() << surface << " case " << i << " t " << t[i] << " tau " << tau
                                            << " k " << k << " s " << at.sine << " depth " << at.depth);
            ASSERT_NEAR(found[i].x, trueDepth(surface, at, tau) / at.depth, tolerance);
            // Compares the slope with a difference quotient of the definition.
            const double step = 1e-4 * found[i].y;
            const double slope = (trueDepth(surface, at, tau + step) - trueDepth(surface, at, tau - step)) /
                                 (2 * step) * found[i].y / at.depth;
            ASSERT_NEAR(found[i].w, slope, 1e-3 * (1 + std::abs(slope)) * std::max(1.0, magnified));
            // st: of the foot point, otherwise of the ray.
            const Vec3 point = tau * ray;
            const Vec2 place =
                surface == "quadric_nearest" ? nearestByTrying(at, point).place : Vec2(point.x, point.y);
            const Vec2 st = at.oblique(place.x, place.y) / at.scale;
            const double size = tau * (1 + 1 / at.tangentSine());
            // The search ends at 1e-9 of the depth, where the squared distance no longer changes, so the
            // position is accurate to 1e-4.
            const double placeTolerance =
                32 * kFloatEpsilon * size + (surface == "quadric_nearest" ? 3e-4 * at.depth : 0);
            ASSERT_NEAR(a[i].x * at.scale.x, st.x * at.scale.x, placeTolerance / at.tangentSine());
            ASSERT_NEAR(a[i].y * at.scale.y, st.y * at.scale.y, placeTolerance / at.tangentSine());
        }
        EXPECT_GT(compared, cases.size() * 9 / 10) << surface;
    }
}

/// Checks the end of a search interval: d has the returned value there, and the search doesn't end earlier.
void checkEnd(const std::string& surface, const Case& at, const glm::vec4& found, double tolerance) {
    const double end = found.y;
    ASSERT_TRUE(std::isfinite(end));
    ASSERT_GT(end, 0);
    EXPECT_EQ(found.x, found.z); // d at t = 1 is exactly endDepth
    EXPECT_NEAR(trueDepth(surface, at, end) / at.depth, found.z, tolerance);
    for (int i = 1; i < 50; ++i) {
        const double d = trueDepth(surface, at, end * i / 50) / at.depth;
        EXPECT_GT(d, 0) << i;
        if (found.z == 1) {
            EXPECT_LE(d, 1 + tolerance) << i;
        }
    }
}

TEST(QuadricEnd, EveryCurvature_EndsAtFirstRoot) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    std::vector<Case> cases;
    for (const double degrees : {1.0, 30.0, 45.0, 75.0, 89.0}) {
        cases.push_back(planar(degrees, 0));
        for (double f = 1e-12; f <= 1.1e2; f *= 3)
            for (const double sign : {-1.0, 1.0}) {
                Case at = planar(degrees, 0);
                at.a = sign * f / (at.sine * at.sine);
                cases.push_back(at);
            }
    }
    // For a relief deeper than the radius of curvature, three steps don't find the nearest point; sixteen do
    // over a concave base, for up to 200 radii. Over a convex base there is no unique nearest point at such
    // depths.
    constexpr const char* kManySteps = "quadric_nearest:newton_steps=16";
    for (const std::string surface : {kAllQuadrics[0], kAllQuadrics[1], kAllQuadrics[2], kManySteps}) {
        const auto found = evaluateCases(surface, cases, std::vector<double>(cases.size(), 1), kPosition);
        for (size_t i = 0; i < cases.size(); ++i) {
            const Case& at = cases[i];
            const double tau = found[i].y, f = at.a * at.sine * at.sine;
            SCOPED_TRACE(testing::Message() << surface << " a " << at.a << " f " << f << " sine " << at.sine);
            // The root has a few float rounding errors, the discriminant one of its larger term, which the
            // square root magnifies; a rounding error of tau changes D_z by c + 2 |f| tau, and D_U by that
            // divided by its own root.
            const double limit = surface == "quadric_perpendicular"
                                     ? std::sqrt(std::abs(at.sine * at.sine + 4 * at.a * at.cosine() * tau))
                                     : 1;
            const double tolerance = 1e-5 + 64 * kFloatEpsilon * tau * (at.cosine() + 2 * std::abs(f) * tau) /
                                                std::max(limit, 1e-3);
            const double depthInRadii = 2 * at.a * at.depth;
            const bool known = depthInRadii <= 0.5 && depthInRadii >= (surface == kManySteps ? -200 : -0.5);
            if (!surface.starts_with("quadric_nearest")) {
                checkEnd(surface, at, found[i], tolerance);
            } else if (known || found[i].z == 0) {
                checkEnd(surface, at, found[i], std::max(tolerance, 2e-4));
            } else {
                EXPECT_TRUE(std::isfinite(tau) && tau > 0);
                EXPECT_EQ(found[i].x, found[i].z);
            }
        }
    }
}

TEST(QuadricEnd, RandomQuadrics_EndAtFirstRoot) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const std::vector<Case> cases = randomCases(2000, 15);
    for (const std::string surface : kAllQuadrics) {
        const auto found = evaluateCases(surface, cases, std::vector<double>(cases.size(), 1), kPosition);
        size_t wrong = 0;
        for (size_t i = 0; i < cases.size(); ++i) {
            const Case& at = cases[i];
            SCOPED_TRACE(testing::Message()
                         << surface << " case " << i << " a " << at.a << " b " << at.b << " c " << at.c
                         << " sine " << at.sine << " depth " << at.depth << " end " << found[i].y);
            checkEnd(surface, at, found[i], 2e-4);
            if (testing::Test::HasFailure() && ++wrong > 3) return;
        }
    }
}

/// Where D_z reaches 1, or otherwise 0, in world units, and where the ray returns to the base, infinity if it
/// doesn't.
struct VerticalEnd {
    double deep, back;
};
VerticalEnd verticalEnd(const Case& at) {
    const double f = at.along(Vec2(at.ray().x, at.ray().y)), c = at.cosine(), rest = c * c - 4 * f * at.depth;
    const double back = f > 0 ? c / f : kInfinity;
    return {rest >= 0 ? 2 * at.depth / (c + std::sqrt(rest)) : back, back};
}

TEST(QuadricEnd, Saddle_EndsNearNearestPoint) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Near the asymptotes of saddles, where the base curves away from the ray (f > 0), toward it (f < 0) or
    // not at all, D_z reaches 1 but D_n often doesn't: it stays below 1 forever (f <= 0) or until the ray
    // returns to the base at c / f, however far. Roots count up to four times the length of D_z's interval;
    // otherwise the search ends at the end of D_z.
    std::vector<Case> cases;
    for (const double ratio : {1.0, 0.3})
        for (const double depth : {0.1, 0.3, 0.5}) // in radii of curvature
            for (const double degrees : {30.0, 50.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0})
                for (const double beside : {-0.2, -0.05, -1e-3, 0.0, 1e-6, 1e-3, 0.02, 0.05, 0.1, 0.2, 0.4}) {
                    Case at = planar(degrees, 0.5);
                    at.b = -0.5 * ratio;
                    at.azimuth = std::atan(1 / std::sqrt(ratio)) - beside;
                    at.depth = depth;
                    cases.push_back(at);
                }
    const std::string surface = "quadric_nearest:newton_steps=16";
    const auto found = evaluateCases(surface, cases, std::vector<double>(cases.size(), 1), kPosition);
    size_t deep = 0, back = 0, cut = 0;
    for (size_t i = 0; i < cases.size(); ++i) {
        const Case& at = cases[i];
        const VerticalEnd vertical = verticalEnd(at);
        SCOPED_TRACE(testing::Message()
                     << "case " << i << " b " << at.b << " sine " << at.sine << " azimuth " << at.azimuth
                     << " depth " << at.depth << " deep " << vertical.deep << " back " << vertical.back
                     << " end " << found[i].y << " " << found[i].z);
        const double furthest = std::min(4 * vertical.deep, vertical.back);
        double deepest = 0;
        for (int step = 1; step < 200; ++step)
            deepest = std::max(deepest, trueDepth(surface, at, furthest * step / 200) / at.depth);
        if (std::abs(deepest - 1) < 1e-3) continue; // too close to decide
        checkEnd(surface, at, found[i], 2e-4);
        if (deepest > 1) {
            ++deep;
            EXPECT_EQ(found[i].z, 1);
        } else if (vertical.back <= 4 * vertical.deep) {
            ++back;
            EXPECT_EQ(found[i].z, 0);
            EXPECT_NEAR(found[i].y / vertical.back, 1, 1e-4);
        } else {
            ++cut;
            EXPECT_LT(found[i].z, 1);
            EXPECT_NEAR(found[i].y / vertical.deep, 1, 1e-4);
        }
    }
    EXPECT_GT(deep, 30u);
    EXPECT_GT(back, 30u);
    EXPECT_GT(cut, 30u);
}

// --- the frame at the hit ------------------------------------------------------------------------

/// The point of the relief of constant depth at the point (x, y) of the base, displaced along the base's
/// normal or along Z.
Vec3 displaced(const Case& at, const Vec2& st, double depth, bool alongOwnNormal) {
    const auto surface = [&](const Vec2& p) { // oblique coordinates
        const double x = p.x + at.tangentCosine * p.y, y = at.tangentSine() * p.y;
        return Vec3(x, y, at.base(x, y));
    };
    const Vec2 place = st * at.scale;
    const Vec3 point = surface(place);
    if (!alongOwnNormal) return point - Vec3(0, 0, depth);
    const double step = 1e-4;
    const Vec3 normal =
        glm::normalize(glm::cross(surface(place + Vec2(step, 0)) - surface(place - Vec2(step, 0)),
                                  surface(place + Vec2(0, step)) - surface(place - Vec2(0, step))));
    return point - depth * normal;
}

TEST(QuadricFrameAtTheHit, ConstantDepth_GivesFrameFromDerivatives) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const std::vector<Case> cases = randomCases(1000, 25);
    const std::vector<double> t(cases.size(), 0.6);
    const auto component = [](const char* value) {
        return std::string("vec4 evaluate(vec4 a) {\n"
                           "  ReliefRay ray;\n"
                           "  bool enters = enterRelief(frameOf(a), vec2(0.0), texel(a, 1).xyz, ray);\n"
                           "  return vec4(frameAt(frameOf(a), ray, a.y).") +
               value + ", surfacePosition(ray, a.y).z);\n}";
    };
    for (const std::string surface : kAllQuadrics) {
        const bool nearest = surface == "quadric_nearest";
        const auto byS = evaluateCases(surface, cases, t, component("positionS")),
                   byT = evaluateCases(surface, cases, t, component("positionT")),
                   normals = evaluateCases(surface, cases, t, component("normal")),
                   texture = evaluateCases(surface, cases, t, kTexture);
        for (size_t i = 0; i < cases.size(); ++i) {
            const Case& at = cases[i];
            SCOPED_TRACE(testing::Message() << surface << " case " << i);
            const Vec2 st(texture[i].x, texture[i].y);
            const double depth = byS[i].w * at.depth, step = 1e-4;
            const Vec2 alongS(step / at.scale.x, 0), alongT(0, step / at.scale.y);
            const auto slope = [&](const Vec2& way) {
                return (displaced(at, st + way, depth, nearest) - displaced(at, st - way, depth, nearest)) /
                       (2 * step);
            };
            // Difference quotients with step 1e-4 have errors of 1e-8 times the third derivative and of 1e-11
            // / 1e-4.
            ASSERT_LT(glm::length(Vec3(byS[i]) / at.scale.x - slope(alongS)),
                      2e-5 * (1 + glm::length(slope(alongS))));
            ASSERT_LT(glm::length(Vec3(byT[i]) / at.scale.y - slope(alongT)),
                      2e-5 * (1 + glm::length(slope(alongT))));
            const Vec3 normal =
                nearest ? glm::normalize(glm::cross(slope(alongS), slope(alongT))) : Vec3(0, 0, 1);
            ASSERT_LT(glm::length(Vec3(normals[i]) - normal), 2e-5);
        }
    }
}

} // namespace
} // namespace plumbline
