// Convergence rates of searches, and the errata on the secant method.
#include "tests/realtime/draw/search_rays.h"

#include <algorithm>
#include <cstring>

namespace plumbline {
namespace {

// --- rates ---------------------------------------------------------------------------------------

/// Mean |t - ground truth| over the rays whose first hit was found, that is, within `step`; and the number of
/// these rays.
struct Error {
    double mean;
    size_t rays;
};
Error errorOf(const std::string& technique, const HeightMap& map, const std::vector<ReliefLine>& lines,
              double step) {
    const std::vector<TracedHit> found = traceGlsl(technique, map, lines),
                                 truth = traceGlsl("exact_cells", map, lines);
    Error error{0, 0};
    for (size_t i = 0; i < lines.size(); ++i) {
        const double difference = std::abs(found[i].t - truth[i].t);
        if (difference > step) continue;
        error.mean += difference;
        ++error.rays;
    }
    error.mean /= static_cast<double>(error.rays);
    return error;
}

TEST(Convergence, MoreSteps_ConvergeWithExpectedOrder) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Waves of 512 texels, which are smooth over steps of 1/8 to 1/32 of rays 0.2 tiles long (13 to 3
    // texels). Doubling the steps halves the error of a linear search and of one with a fixed number of
    // bisections, and quarters that of one secant step.
    const HeightMap map = generated("waves", 512);
    const std::vector<ReliefLine> lines = raysOfLength(0.2f, 3000);
    const struct {
        const char *technique, *rest;
        double order, band;
    } cases[] = {{"linear", "", 1, 0.1},
                 {"linear_binary", ",binary_steps=4", 1, 0.1},
                 {"linear_secant1", "", 2, 0.25}};
    for (const auto& c : cases) {
        double previous = 0;
        for (const int steps : {8, 16, 32}) {
            const std::string name =
                std::string(c.technique) + ":linear_steps=" + std::to_string(steps) + c.rest;
            const Error error = errorOf(name, map, lines, 1.0 / steps);
            EXPECT_GT(error.rays, lines.size() * 95 / 100) << name;
            if (previous > 0) {
                EXPECT_NEAR(std::log2(previous / error.mean), c.order, c.band) << name;
            }
            previous = error.mean;
            RecordProperty(name, std::to_string(error.mean));
        }
    }
    // Uniform over the last interval: half a step on average; a bisection halves it.
    EXPECT_NEAR(errorOf("linear:linear_steps=32", map, lines, 1.0 / 32).mean, 0.5 / 32, 0.05 / 32);
    for (const int halvings : {1, 2, 5})
        EXPECT_NEAR(errorOf("linear_binary:linear_steps=32,binary_steps=" + std::to_string(halvings), map,
                            lines, 1.0 / 32)
                        .mean,
                    0.5 / 32 * std::exp2(-halvings), 0.05 / 32 * std::exp2(-halvings));
}

// --- the secant's errata -------------------------------------------------------------------------

struct Iterations {
    double mean;
    int p99, most;
    double overTen; // share
};
Iterations iterationsOf(const std::string& technique, const HeightMap& map,
                        const std::vector<ReliefLine>& lines) {
    std::vector<int> counts;
    for (const TracedHit& hit : traceGlsl(technique, map, lines))
        if (hit.iterations > 0) counts.push_back(hit.iterations);
    std::sort(counts.begin(), counts.end());
    Iterations result{0, counts[counts.size() * 99 / 100], counts.back(), 0};
    for (const int count : counts) {
        result.mean += count;
        result.overTen += count > 10;
    }
    result.mean /= static_cast<double>(counts.size());
    result.overTen /= static_cast<double>(counts.size());
    return result;
}

TEST(Secant, Walls_FreezeRegulaFalsiNotIllinois) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // E1, with the paper's 5 linear steps and |gap| <= 0.01, and no effective limit of iterations.
    const auto print = [](const char* name, const Iterations& n) {
        testing::Test::RecordProperty(name, std::to_string(n.mean) + " p99 " + std::to_string(n.p99) +
                                                " max " + std::to_string(n.most) + " over ten " +
                                                std::to_string(n.overTen));
    };
    const std::vector<ReliefLine> lines = raysOfLength(0.5f, 4000);
    const HeightMap walls = generated("bricks", 256), smooth = generated("waves", 256);
    const std::string common = "linear_secant:max_iterations=64,method=";
    const std::string binary = "linear_binary:linear_steps=5,binary_steps=32,tolerance=0.01";
    const Iterations printed = iterationsOf(common + "regula_falsi", walls, lines);
    const Iterations illinois = iterationsOf(common + "illinois", walls, lines);
    const Iterations halved = iterationsOf(binary, walls, lines);
    print("regula_falsi_bricks", printed);
    print("illinois_bricks", illinois);
    print("binary_bricks", halved);
    // Measured: 5.55, p99 21, 10 % over ten; 4.55, p99 10, 0.8 %; 5.88, p99 9. The tolerances allow for
    // another map.
    EXPECT_GT(printed.mean, illinois.mean * 1.1);
    EXPECT_GT(printed.p99, 1.5 * illinois.p99);
    EXPECT_GT(printed.overTen, 0.05);
    EXPECT_LT(illinois.overTen, 0.02);
    EXPECT_GT(printed.p99, 1.5 * halved.p99); // the worst cases aren't equal
    // On smooth maps the paper's claim, two to three iterations instead of five to eight, is confirmed for
    // the former: 1.96 and 3.76.
    const Iterations printedSmooth = iterationsOf(common + "regula_falsi", smooth, lines);
    const Iterations illinoisSmooth = iterationsOf(common + "illinois", smooth, lines);
    const Iterations halvedSmooth = iterationsOf(binary, smooth, lines);
    print("regula_falsi_waves", printedSmooth);
    print("illinois_waves", illinoisSmooth);
    print("binary_waves", halvedSmooth);
    EXPECT_LT(illinoisSmooth.mean, 3);
    EXPECT_NEAR(printedSmooth.mean, illinoisSmooth.mean, 0.3);
    EXPECT_GT(halvedSmooth.mean, illinoisSmooth.mean + 1);
}

TEST(Secant, EitherEnd_CanFreeze) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // A ray over the whole map of 64 texels, D as a function of t = s. Five steps leave the interval [0.8,
    // 1]. In the first map the relief is 0.05 below the ray up to a wall at 0.97, so the outside gap is small
    // and the inside end doesn't move. In the second it rises at 0.82 from the floor to 0.02 above the ray,
    // so the outside end doesn't move. Measured: 37 iterations and 14, 25 and 8.
    std::vector<float> late(64), early(64);
    for (size_t i = 0; i < 64; ++i) {
        const float s = (static_cast<float>(i) + 0.5f) / 64;
        late[i] = s < 0.97f ? s + 0.05f > 1 ? 1 : s + 0.05f : 0.0f;
        early[i] = s < 0.82f ? 1.0f : s - 0.02f;
    }
    for (const HeightMap& map : {profile(late, Wrap::Clamp), profile(early, Wrap::Clamp)}) {
        const std::string name = "linear_secant:max_iterations=64,method=";
        const TracedHit printed = traceOne(name + "regula_falsi", map, {{0, 0.5f}, {1, 0}});
        const TracedHit illinois = traceOne(name + "illinois", map, {{0, 0.5f}, {1, 0}});
        EXPECT_GT(printed.iterations, illinois.iterations * 3 / 2);
        EXPECT_LE(illinois.iterations, 16);
        EXPECT_NEAR(illinois.t, traceOne("exact_cells", map, {{0, 0.5f}, {1, 0}}).t, 0.01);
    }
}

TEST(Secant, SteepRelief_SampledDepthIsWorseThanIntersection) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // E2: t + (D - t) instead of t multiplies the error by the slope of D along the ray per unit of t. Waves
    // have slopes of about 2 per tile, so that it is about 2 for rays a tile long and 0.3 for those of 0.15
    // tiles: there the printed answer is better.
    const HeightMap map = generated("waves", 256);
    const auto compare = [&](float travel) {
        const std::vector<ReliefLine> lines = raysOfLength(travel, 4000);
        const auto truth = traceGlsl("exact_cells", map, lines);
        const auto point = traceGlsl("linear_secant", map, lines);
        const auto sampled = traceGlsl("linear_secant:answer=sampled_depth", map, lines);
        double worse = 0, count = 0, errorOfPoint = 0, errorOfSampled = 0;
        for (size_t i = 0; i < lines.size(); ++i) {
            const double a = std::abs(point[i].t - truth[i].t), b = std::abs(sampled[i].t - truth[i].t);
            if (a > 0.1 || a < 1e-6) continue; // another hit, or no error to multiply
            worse += b > a;
            ++count;
            errorOfPoint += a;
            errorOfSampled += b;
        }
        return std::pair(worse / count, errorOfSampled / errorOfPoint);
    };
    const auto [worseShare, ratio] = compare(1);
    EXPECT_GT(worseShare, 0.8); // found 0.907
    EXPECT_NEAR(ratio, 1.8, 0.4);
    const auto [worseShareSteep, ratioSteep] = compare(0.15f);
    EXPECT_LT(worseShareSteep, 0.05); // found 0.002
    EXPECT_NEAR(ratioSteep, 0.32, 0.15);
}

} // namespace
} // namespace plumbline
