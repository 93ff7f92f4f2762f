#include "tests/bench/stage_bench.h"

#include "reference/tessellate/lattice.h"
#include "reference/tessellate/tessellate.h"
#include "reference/trace/embree.h"
#include "reference/trace/embree_scene.h"
#include "reference/trace/render.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "scenes/surface/displaced_surface.h"

#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace plumbline {

namespace {

constexpr int kRates[] = {64, 128, 256}; // 1.05, 4.19 and 16.8 M micro-triangles
constexpr int kRepetitions = 5;

/// The scene with one object, its surface, and the rays of its image.
struct Torus {
    Scene scene = readScene(findScene("stone_torus"));
    std::unique_ptr<BaseSurface> surface = makeBaseSurface(scene.objects[0]);
    const Relief* relief = &*scene.objects[0].relief;
};
const Torus& torus() {
    static const Torus instance;
    return instance;
}

using Clock = std::chrono::steady_clock;

template <typename Work>
double seconds(Work work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Times `stage` and, after each run of it, `bare`. They alternate because the speed of machines drifts and
/// the ratio of both is measured.
template <typename Stage, typename Bare>
void runPaired(benchmark::State& state, double items, Stage stage, Bare bare) {
    std::vector<double> ratios;
    for (auto _ : state) {
        const double stageSeconds = seconds(stage);
        state.SetIterationTime(stageSeconds);
        ratios.push_back(seconds(bare) / stageSeconds);
    }
    std::sort(ratios.begin(), ratios.end());
    state.counters["of_bare"] = ratios[ratios.size() / 2];
    state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(items));
}

/// Bare: OpenSubdiv only, the same number of samples with first derivatives, on all cores.
void tessellateStage(benchmark::State& state) {
    const int rate = static_cast<int>(state.range(0));
    const int patchCount = static_cast<int>(torus().surface->patches().size());
    const auto microTriangles = static_cast<double>(
        microMeshSize(*torus().surface, uniformRates(*torus().surface, rate)).microTriangles);
    runPaired(
        state, microTriangles,
        [&] {
            benchmark::DoNotOptimize(
                tessellate(*torus().surface, torus().relief, uniformRates(*torus().surface, rate), false));
        },
        [&] {
            tbb::parallel_for(0, patchCount, [&](int patch) {
                BaseSurface::Evaluator evaluator(*torus().surface);
                evaluator.setPatch(patch);
                Vec3 sum(0);
                for (int row = 0; row < rate; ++row)
                    for (int column = 0; column < rate; ++column)
                        sum += evaluator.point(double(column) / rate, double(row) / rate).position;
                benchmark::DoNotOptimize(sum);
            });
        });
}

void buildStage(benchmark::State& state) {
    const Rates rates = uniformRates(*torus().surface, static_cast<int>(state.range(0)));
    std::vector<MicroMesh> meshes;
    meshes.push_back(tessellate(*torus().surface, torus().relief, rates, false));
    for (auto _ : state)
        state.SetIterationTime(seconds([&] { benchmark::DoNotOptimize(EmbreeScene(meshes)); }));
    state.SetItemsProcessed(state.iterations() *
                            static_cast<int64_t>(microMeshSize(*torus().surface, rates).microTriangles));
}

/// Origins of a frame's shadow rays: every lit or cast-shadowed point, offset from the surface.
std::vector<Vec3f> shadowRayOrigins(const Frame& frame, const Vec3& toLight) {
    std::vector<Vec3f> origins;
    for (size_t i = 0; i < frame.pixelCount(); ++i) {
        const auto at = [&](const char* channel) { return double(frame.channel(channel)[i]); };
        const Vec3 normal(at("N.X"), at("N.Y"), at("N.Z"));
        if (at("A") > 0 && glm::dot(normal, toLight) > 0)
            origins.push_back(Vec3(at("P.X"), at("P.Y"), at("P.Z")) + 1e-5 * normal);
    }
    return origins;
}

template <typename Body>
void forEachFlushed(size_t count, Body body) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 1024), [&](const auto& range) {
        const FlushDenormals flush;
        for (size_t i = range.begin(); i < range.end(); ++i)
            body(i);
    });
}

/// The torus at a rate, traced once: the rays of its frame.
struct TracedTorus {
    std::vector<MicroMesh> meshes;
    EmbreeScene embree, bare;
    std::vector<TracedObject> objects;
    Frame frame;
    std::vector<Vec3f> shadowOrigins;
    CameraRays rays;

    explicit TracedTorus(int rate)
        : meshes(makeMeshes(rate)), embree(meshes),
          bare(meshes, LeakGuard::Off), objects{{&torus().scene.objects[0], torus().relief,
                                                 torus().surface.get(), &meshes[0]}},
          frame(render()), shadowOrigins(shadowRayOrigins(frame, toLight())), rays(torus().scene.camera) {}

    static std::vector<MicroMesh> makeMeshes(int rate) {
        std::vector<MicroMesh> meshes;
        meshes.push_back(
            tessellate(*torus().surface, torus().relief, uniformRates(*torus().surface, rate), false));
        return meshes;
    }
    static Vec3 toLight() { return torus().scene.lights[0].toLightWorld; }
    Frame render() const { return traceFrame(torus().scene, objects, embree).frame; }
    /// The frame's rays without further work.
    void traceRays(const EmbreeScene& scene) const {
        const auto width = static_cast<size_t>(frame.width());
        forEachFlushed(frame.pixelCount(), [&](size_t i) {
            const Ray ray = rays.ray(double(i % width) + 0.5, double(i / width) + 0.5);
            benchmark::DoNotOptimize(scene.intersect(ray.origin, ray.direction));
        });
        forEachFlushed(shadowOrigins.size(), [&](size_t i) {
            benchmark::DoNotOptimize(scene.occluded(shadowOrigins[i], toLight(), kInfinityF));
        });
    }
    double rayCount() const { return static_cast<double>(frame.pixelCount() + shadowOrigins.size()); }
};

/// The frame's rays, without leaks at vertices. Bare: Embree alone.
void raysStage(benchmark::State& state) {
    const TracedTorus traced(static_cast<int>(state.range(0)));
    runPaired(
        state, traced.rayCount(), [&] { traced.traceRays(traced.embree); },
        [&] { traced.traceRays(traced.bare); });
}

/// The whole frame: rays, hits refined onto the surface in double, normals by second derivatives, color.
/// Bare: Embree's rays alone.
void traceStage(benchmark::State& state) {
    const TracedTorus traced(static_cast<int>(state.range(0)));
    runPaired(
        state, traced.rayCount(), [&] { benchmark::DoNotOptimize(traced.render()); },
        [&] { traced.traceRays(traced.bare); });
}

/// Prints and stores the medians.
class KeepingReporter : public benchmark::ConsoleReporter {
  public:
    KeepingReporter() : ConsoleReporter(OO_None) {}
    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<Run> kept;
        for (const Run& run : runs)
            if (run.aggregate_name == "median") kept.push_back(run);
        ConsoleReporter::ReportRuns(kept);
        for (const Run& run : kept) {
            StageResult& result = medians[run.run_name.function_name + "/" + run.run_name.args];
            result.realMs = run.GetAdjustedRealTime();
            result.itemsPerSecond = run.counters.at("items_per_second");
            const auto ratio = run.counters.find("of_bare");
            result.ofBare = ratio == run.counters.end() ? 0 : static_cast<double>(ratio->second);
        }
    }
    std::map<std::string, StageResult> medians;
};

} // namespace

void registerStageBenchmarks() {
    const std::pair<const char*, benchmark::internal::Function*> stages[] = {{"tessellate", tessellateStage},
                                                                             {"embree_build", buildStage},
                                                                             {"rays", raysStage},
                                                                             {"trace", traceStage}};
    for (const auto& [name, function] : stages)
        for (const int rate : kRates)
            benchmark::RegisterBenchmark(name, function)
                ->Arg(rate)
                ->Unit(benchmark::kMillisecond)
                ->Repetitions(kRepetitions)
                ->ReportAggregatesOnly()
                ->UseManualTime();
}

std::map<std::string, StageResult> runStageBenchmarks() {
    KeepingReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return reporter.medians;
}

} // namespace plumbline
