#include "stage_bench.h"

#include "../../reference/embree.h"
#include "../../reference/embree_scene.h"
#include "../../reference/grid_layout.h"
#include "../../reference/render.h"
#include "../../reference/tessellate.h"
#include "../../scenes/displaced_surface.h"
#include "../../scenes/scene_file.h"

#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <memory>

namespace plumbline {

namespace {

constexpr int kRates[] = {64, 128, 256}; // 1.05, 4.19 and 16.8 M micro-triangles
constexpr int kRepetitions = 5;

/// The scene with one object, its surface, and the rays of its picture.
struct Torus {
    Scene scene = readScene(findScene("stone_torus"));
    std::unique_ptr<BaseSurface> surface = makeBaseSurface(scene.objects[0]);
    const Relief* relief = &*scene.objects[0].relief;
};
const Torus& torus() {
    static const Torus instance;
    return instance;
}

void tessellateStage(benchmark::State& state) {
    const int rate = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(tessellate(*torus().surface, torus().relief, rate, false));
    state.SetItemsProcessed(state.iterations() *
                            static_cast<int64_t>(microMeshSize(*torus().surface, rate).microTriangles));
}

/// Nothing but OpenSubdiv: the same number of samples with first derivatives, on all cores.
void bareBfrStage(benchmark::State& state) {
    const int rate = static_cast<int>(state.range(0));
    const int patchCount = static_cast<int>(torus().surface->patches().size());
    for (auto _ : state)
        tbb::parallel_for(0, patchCount, [&](int patch) {
            BaseSurface::Evaluator evaluator(*torus().surface);
            evaluator.setPatch(patch);
            Vec3 sum(0);
            for (int row = 0; row < rate; ++row)
                for (int column = 0; column < rate; ++column)
                    sum += evaluator.point(double(column) / rate, double(row) / rate).position;
            benchmark::DoNotOptimize(sum);
        });
    state.SetItemsProcessed(state.iterations() *
                            static_cast<int64_t>(microMeshSize(*torus().surface, rate).microTriangles));
}

void buildStage(benchmark::State& state) {
    std::vector<MicroMesh> meshes;
    meshes.push_back(tessellate(*torus().surface, torus().relief, static_cast<int>(state.range(0)), false));
    for (auto _ : state)
        benchmark::DoNotOptimize(EmbreeScene(meshes));
    state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(meshes[0].microTriangleCount));
}

/// The torus in Embree, with the frame it gives.
struct TracedTorus {
    std::vector<MicroMesh> meshes;
    std::unique_ptr<EmbreeScene> embree;
    RayCounts rays;

    explicit TracedTorus(int rate) {
        meshes.push_back(tessellate(*torus().surface, torus().relief, rate, false));
        embree = std::make_unique<EmbreeScene>(meshes);
    }
    Frame render() {
        rays = {};
        return renderFrame(torus().scene, {{&torus().scene.objects[0], torus().surface.get(), &meshes[0]}},
                           *embree, rays);
    }
};

void traceStage(benchmark::State& state) {
    TracedTorus traced(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(traced.render());
    state.SetItemsProcessed(state.iterations() *
                            static_cast<int64_t>(traced.rays.camera + traced.rays.shadow));
}

/// The same rays with nothing around them: camera rays made and intersected, shadow rays from the frame's
/// points.
void bareTraceStage(benchmark::State& state) {
    TracedTorus traced(static_cast<int>(state.range(0)));
    const Frame frame = traced.render();
    const CameraRays rays(torus().scene.camera);
    const Vec3 toLight = torus().scene.lights[0].toLightWorld;
    std::vector<Vec3f> shadowOrigins;
    for (size_t i = 0; i < frame.pixelCount(); ++i) {
        const auto at = [&](const char* channel) { return double(frame.channel(channel)[i]); };
        const Vec3 normal(at("N.X"), at("N.Y"), at("N.Z"));
        if (at("A") > 0 && glm::dot(normal, toLight) > 0)
            shadowOrigins.push_back(Vec3(at("P.X"), at("P.Y"), at("P.Z")) + 1e-5 * normal);
    }
    const auto width = static_cast<size_t>(frame.width());
    for (auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<size_t>(0, frame.pixelCount(), 1024), [&](const auto& range) {
            const FlushDenormals flush;
            for (size_t i = range.begin(); i < range.end(); ++i) {
                const Ray ray = rays.ray(double(i % width) + 0.5, double(i / width) + 0.5);
                benchmark::DoNotOptimize(traced.embree->intersect(ray.origin, ray.direction));
            }
        });
        tbb::parallel_for(tbb::blocked_range<size_t>(0, shadowOrigins.size(), 1024), [&](const auto& range) {
            const FlushDenormals flush;
            for (size_t i = range.begin(); i < range.end(); ++i)
                benchmark::DoNotOptimize(traced.embree->occluded(shadowOrigins[i], toLight, kInfinityF));
        });
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<int64_t>(frame.pixelCount() + shadowOrigins.size()));
}

/// Prints as usual and keeps the medians.
class KeepingReporter : public benchmark::ConsoleReporter {
  public:
    KeepingReporter() : ConsoleReporter(OO_None) {}
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.aggregate_name != "median") continue;
            StageResult& result = medians[run.run_name.function_name + "/" + run.run_name.args];
            result.realMs = run.GetAdjustedRealTime();
            result.itemsPerSecond = run.counters.at("items_per_second");
        }
    }
    std::map<std::string, StageResult> medians;
};

} // namespace

void registerStageBenchmarks() {
    const std::pair<const char*, benchmark::internal::Function*> stages[] = {{"tessellate", tessellateStage},
                                                                             {"bare_bfr", bareBfrStage},
                                                                             {"embree_build", buildStage},
                                                                             {"trace", traceStage},
                                                                             {"bare_trace", bareTraceStage}};
    for (const auto& [name, function] : stages)
        for (const int rate : kRates)
            benchmark::RegisterBenchmark(name, function)
                ->Arg(rate)
                ->Unit(benchmark::kMillisecond)
                ->Repetitions(kRepetitions)
                ->ReportAggregatesOnly()
                ->UseRealTime();
}

std::map<std::string, StageResult> runStageBenchmarks() {
    KeepingReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return reporter.medians;
}

} // namespace plumbline
