#include "tests/bench/bake_bench.h"

#include "realtime/bake/bake.h"
#include "realtime/bake/cone_map.h"
#include "realtime/bake/cone_search.h"
#include "scenes/maps/generate_map.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace plumbline {
namespace {

constexpr int kSizes[] = {128, 256, 512, 1024, 2048};
constexpr int kDefinitionSize = 128, kFieldSize = 256;
constexpr double kLongSeconds = 30; // a run is skipped if four times the time of the smaller one exceeds this

const char* const kConeKinds[] = {"cone_step", "cone_step_relaxed", "cone_step_relaxed_2007",
                                  "cone_step_quad"};

template <typename Work>
double seconds(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <typename Work>
double medianSeconds(int runs, Work work) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i)
        times.push_back(seconds(work));
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

double bakeSeconds(const HeightMap& map, const std::string& kind) {
    BakeRequest request;
    request.kind = kind;
    const int runs = map.width() <= 512 ? 5 : 1;
    return medianSeconds(runs, [&] { benchmark::DoNotOptimize(bakeMap(map, request)); });
}

HeightMap seamlessMap(const std::string& generated, int size) {
    return generateMap(generated, size, 1, Wrap::Repeat, Wrap::Repeat);
}

/// The brute-force computation of slice 0: all pairs, with the nearest periodic images of each, on all
/// threads.
double definitionSeconds(const HeightMap& map, const ConeRule& rule) {
    const ConePairs pairs(map, ConeSlice::Texels, rule);
    return seconds([&] {
        tbb::parallel_for(0, map.height(), [&](int row) {
            for (int column = 0; column < map.width(); ++column) {
                double steepest = 1;
                const double depth = map.texel(column, row);
                for (int kt = -map.height() + 1; kt < map.height(); ++kt)
                    for (int ks = -map.width() + 1; ks < map.width(); ++ks) {
                        const double drop = depth - map.texel(column + ks, row + kt);
                        if (!(drop > 0)) continue;
                        const double slope = drop * drop / pairs.distanceSquared(ks, kt);
                        if (slope > steepest && pairs.counts(column, row, ks, kt, kAllDirections))
                            steepest = slope;
                    }
                benchmark::DoNotOptimize(keptSlopeSquared(steepest));
            }
        });
    });
}

void printCones(const std::string& kind, const std::string& generated) {
    fmt::print("{:<24}{:<10}", kind, generated);
    double before = 0;
    for (const int size : kSizes) {
        if (4 * before > kLongSeconds) {
            fmt::print("{:>11}", "–");
            continue;
        }
        before = bakeSeconds(seamlessMap(generated, size), kind);
        fmt::print("{:>9.3f} s", before);
        std::fflush(stdout);
    }
    fmt::print("\n");
}

void printDefinition() {
    fmt::print("\n{:<24}{:<10}{:>14}{:>14}{:>10}\n", fmt::format("texels, {0} x {0}", kDefinitionSize), "map",
               "all pairs", "whole bake", "ratio");
    for (const char* kind : {"cone_step", "cone_step_relaxed"})
        for (const char* generated : {"cobbles", "noise", "waves"}) {
            const HeightMap map = seamlessMap(generated, kDefinitionSize);
            const double all = definitionSeconds(map, coneRule(kind)), bake = bakeSeconds(map, kind);
            fmt::print("{:<24}{:<10}{:>12.3f} s{:>12.3f} s{:>9.0f}x\n", kind, generated, all, bake,
                       all / bake);
        }
}

void printDistanceField() {
    if (!isBakeKind("distance_field")) return;
    const double field = bakeSeconds(seamlessMap("cobbles", kFieldSize), "distance_field");
    fmt::print("{:<44}{:>8.3f} s   (aim 1 s)\n", fmt::format("distance_field, {0} x {0} x 64", kFieldSize),
               field);
}

} // namespace

void printBakes() {
    fmt::print("\nbaked maps, both slices (aims of cone_step and cone_step_relaxed: 256 in 0.2 s, 1024 in 4 "
               "s, 2048 in 20 s)\n");
    fmt::print("{:<24}{:<10}", "kind", "map");
    for (const int size : kSizes)
        fmt::print("{:>11}", size);
    fmt::print("\n");
    for (const char* kind : kConeKinds)
        for (const std::string& generated : generatedMapKinds())
            printCones(kind, generated);
    printDefinition();
    printDistanceField();
}

} // namespace plumbline
