#include "reference/reference.h"

#include "reference/certify/certify.h"
#include "reference/rates/rate.h"
#include "reference/tessellate/lattice.h"
#include "reference/tessellate/tessellate.h"
#include "reference/trace/embree_scene.h"
#include "reference/trace/render.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/header_fields.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/seams.h"

#include <fmt/format.h>

#include <chrono>

namespace plumbline {

namespace {

class Stopwatch {
  public:
    double elapsedMs() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

// Runs until the error aimed at is met. Rates are planned from the grids of each face that are worst at its
// first rate; the second plan knows by how much that was off.
constexpr int kMaxRuns = 3;

struct ReferenceScene::Impl {
    const Scene& scene;
    ReferenceOptions options;
    ReferenceStats stats;
    std::vector<std::unique_ptr<BaseSurface>> surfaces;
    std::vector<std::optional<Relief>> reliefs; // per object, as they go on the base
    std::vector<MicroMesh> meshes;
    std::unique_ptr<EmbreeScene> embree;
    std::unique_ptr<RatePlanner> planner; // null: one rate for all
    std::string limit;                    // Certificate::limit as far as it is known

    Impl(const Scene& sceneGiven, const ReferenceOptions& optionsGiven)
        : scene(sceneGiven), options(optionsGiven) {
        if (options.memoryBytes == 0) options.memoryBytes = freeMemoryBytes() / 2;
        const Stopwatch watch;
        for (const SceneObject& object : scene.objects) {
            surfaces.push_back(makeBaseSurface(object, options.base));
            reliefs.push_back(reliefOn(object, options.base));
            const std::vector<std::string> warnings = surfaceWarnings(object, *surfaces.back());
            stats.warnings.insert(stats.warnings.end(), warnings.begin(), warnings.end());
        }
        if (!options.rate)
            planner =
                std::make_unique<RatePlanner>(scene, plannedObjects(), options.errorPx, options.memoryBytes);
        stats.tessellateMs = watch.elapsedMs();
        build();
    }

    const Relief* reliefOf(size_t object) const { return reliefs[object] ? &*reliefs[object] : nullptr; }

    /// Plans, tessellates and builds the acceleration structure.
    void build() {
        const Stopwatch tessellateWatch;
        embree.reset();
        meshes.clear();
        const RatePlan plan =
            planner ? planner->plan() : planUniformRate(plannedObjects(), options.rate, options.memoryBytes);
        note(plan);
        for (size_t i = 0; i < surfaces.size(); ++i)
            meshes.push_back(tessellate(*surfaces[i], reliefOf(i), plan.rates[i], options.microAttributes));
        stats.tessellateMs += tessellateWatch.elapsedMs();
        const Stopwatch buildWatch;
        std::vector<bool> culled;
        for (const SceneObject& object : scene.objects)
            culled.push_back(object.cull == Cull::Back);
        embree = std::make_unique<EmbreeScene>(meshes, LeakGuard::On, culled);
        stats.buildMs += buildWatch.elapsedMs();
    }

    std::vector<PlannedObject> plannedObjects() const {
        std::vector<PlannedObject> objects;
        for (size_t i = 0; i < surfaces.size(); ++i)
            objects.push_back({surfaces[i].get(), reliefOf(i)});
        return objects;
    }

    void note(const RatePlan& plan) {
        stats.objects.clear();
        for (size_t i = 0; i < surfaces.size(); ++i)
            stats.objects.push_back({scene.objects[i].name, largestRate(plan.rates[i]), plan.wanted[i],
                                     microMeshSize(*surfaces[i], plan.rates[i]).microTriangles});
        stats.microTriangles = plan.microTriangles;
        stats.certificate.pxAim = options.errorPx;
        limit = plan.limit;
    }

    Frame render() {
        MeasuredFrame traced = trace();
        int run = 1;
        while (run < kMaxRuns && isAboveAim() && limit.empty() && refinePlan(traced)) {
            build();
            traced = trace();
            ++run;
        }
        if (!isAboveAim())
            limit.clear();
        else if (limit.empty())
            limit = run == kMaxRuns ? fmt::format("{} runs, each finer than the last", kMaxRuns)
                                    : "places that finer micro-triangles come no closer to";
        stats.certificate.limit = limit;
        const Stopwatch watch;
        markUncertain(scene, tracedObjects(), *embree, traced.evidence, traced.frame);
        stats.certifyMs += watch.elapsedMs();
        describe(traced.frame);
        return std::move(traced.frame);
    }

    bool isAboveAim() const { return stats.certificate.pxP99 > options.errorPx; }

    struct MeasuredFrame : TracedFrame {
        std::vector<float> errorsPx; // of each pixel
    };

    /// The frame but for what is uncertain, and its certificate.
    MeasuredFrame trace() {
        const Stopwatch watch;
        MeasuredFrame traced;
        static_cast<TracedFrame&>(traced) = traceFrame(scene, tracedObjects(), *embree);
        stats.traceMs += watch.elapsedMs();
        const Stopwatch certifyWatch;
        traced.errorsPx = errorsPx(scene.camera, traced.evidence, traced.frame);
        measureCertificate(traced.frame, traced.evidence, traced.errorsPx, stats.certificate);
        stats.certifyMs += certifyWatch.elapsedMs();
        return traced;
    }

    /// Whether the next run can be finer where this one was above the aim.
    bool refinePlan(const MeasuredFrame& traced) {
        return planner->refine(measureFaces(tracedObjects(), traced.frame, traced.evidence, traced.errorsPx));
    }

    std::vector<TracedObject> tracedObjects() const {
        std::vector<TracedObject> objects;
        for (size_t i = 0; i < meshes.size(); ++i)
            objects.push_back({&scene.objects[i], reliefOf(i), surfaces[i].get(), &meshes[i]});
        return objects;
    }

    void describe(Frame& frame) const {
        frame.metadata = sceneMetadata(scene);
        frame.metadata[header::kRenderer] = "reference";
        frame.metadata[header::kBase] = baseName(options.base);
        writeCertificate(stats.certificate, frame.metadata);
        frame.metadata[header::kMicroTriangles] = fmt::format("{}", stats.microTriangles);
        for (size_t i = 0; i < meshes.size(); ++i)
            frame.metadata[header::object(static_cast<int>(i) + 1, header::kObjectRate)] =
                fmt::format("{}", stats.objects[i].rate);
    }
};

ReferenceScene::ReferenceScene(const Scene& scene, const ReferenceOptions& options)
    : impl_(std::make_unique<Impl>(scene, options)) {}
ReferenceScene::~ReferenceScene() = default;
ReferenceScene::ReferenceScene(ReferenceScene&&) noexcept = default;

const std::vector<MicroMesh>& ReferenceScene::microMeshes() const {
    return impl_->meshes;
}
Frame ReferenceScene::render() {
    return impl_->render();
}
const ReferenceStats& ReferenceScene::stats() const {
    return impl_->stats;
}

} // namespace plumbline
