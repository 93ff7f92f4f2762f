#include "reference.h"

#include "../scenes/displaced_surface.h"
#include "../scenes/error.h"
#include "../scenes/scene_metadata.h"
#include "certify.h"
#include "embree_scene.h"
#include "lattice.h"
#include "rate.h"
#include "render.h"
#include "tessellate.h"

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

/// The keys `compare` reads back (validate/certificate.h).
void addCertificate(const Certificate& certificate, std::map<std::string, std::string>& metadata) {
    const std::pair<const char*, double> figures[] = {
        {"error_px_p50", certificate.pxP50},       {"error_px_p99", certificate.pxP99},
        {"error_px_max", certificate.pxMax},       {"error_px_aim", certificate.aimPx},
        {"error_world_p50", certificate.worldP50}, {"error_world_p99", certificate.worldP99},
        {"error_world_max", certificate.worldMax}};
    for (const auto& [key, value] : figures)
        metadata[std::string("certificate.") + key] = fmt::format("{}", value);
    metadata["certificate.error_limit"] = certificate.limit;
}

} // namespace

struct ReferenceScene::Impl {
    const Scene& scene;
    ReferenceOptions options;
    ReferenceStats stats;
    std::vector<std::unique_ptr<BaseSurface>> surfaces;
    std::vector<MicroMesh> meshes;
    std::unique_ptr<EmbreeScene> embree;

    Impl(const Scene& sceneGiven, const ReferenceOptions& optionsGiven)
        : scene(sceneGiven), options(optionsGiven) {
        const Stopwatch tessellateWatch;
        for (const SceneObject& object : scene.objects)
            surfaces.push_back(makeBaseSurface(object));
        chooseRates();
        for (size_t i = 0; i < surfaces.size(); ++i) {
            const SceneObject& object = scene.objects[i];
            meshes.push_back(tessellate(*surfaces[i], object.relief ? &*object.relief : nullptr,
                                        uniformRates(*surfaces[i], stats.objects[i].rate),
                                        options.microAttributes));
        }
        stats.tessellateMs = tessellateWatch.elapsedMs();
        const Stopwatch buildWatch;
        embree = std::make_unique<EmbreeScene>(meshes);
        stats.buildMs = buildWatch.elapsedMs();
    }

    void chooseRates() {
        std::vector<const BaseSurface*> pointers;
        std::vector<int> wanted, rates;
        for (size_t i = 0; i < surfaces.size(); ++i) {
            pointers.push_back(surfaces[i].get());
            wanted.push_back(wantedRate(*surfaces[i], scene.objects[i], scene.camera));
            rates.push_back(options.rate ? std::max(options.rate, smallestRate(*surfaces[i])) : wanted[i]);
        }
        if (options.rate < 0 || options.rate > kMostRate || (options.rate & (options.rate - 1)) != 0)
            throw InputError("--rate", fmt::format("found {}", options.rate),
                             fmt::format("a power of two from 1 to {}", kMostRate));
        // A rate asked for is taken as it is, or refused: never quietly another.
        const std::vector<int> fitting = ratesWithinMemory(pointers, rates, options.memoryBytes);
        if (options.rate && fitting != rates)
            throw MachineError(
                "--rate",
                fmt::format("rate {} doesn't fit --memory {} MB", options.rate, options.memoryBytes >> 20),
                "a smaller rate or more memory");
        for (size_t i = 0; i < surfaces.size(); ++i) {
            const uint64_t triangles =
                microMeshSize(*surfaces[i], uniformRates(*surfaces[i], fitting[i])).microTriangles;
            stats.objects.push_back({scene.objects[i].name, fitting[i], wanted[i], triangles});
            stats.microTriangles += triangles;
        }
        stats.geometryBytes =
            static_cast<uint64_t>(kBytesPerMicroTriangle * static_cast<double>(stats.microTriangles));
    }

    Frame render() {
        const Stopwatch watch;
        std::vector<TracedObject> objects;
        for (size_t i = 0; i < meshes.size(); ++i) {
            const SceneObject& object = scene.objects[i];
            objects.push_back(
                {&object, object.relief ? &*object.relief : nullptr, surfaces[i].get(), &meshes[i]});
        }
        RayCounts counts;
        FrameEvidence evidence;
        Frame frame = traceFrame(scene, objects, *embree, counts, evidence);
        stats.traceMs = watch.elapsedMs();
        const Stopwatch certifyWatch;
        stats.certificate.aimPx = options.errorPx;
        certifyFrame(scene, objects, *embree, evidence, frame, stats.certificate);
        stats.certifyMs = certifyWatch.elapsedMs();
        stats.cameraRays = counts.camera;
        stats.shadowRays = counts.shadow;
        stats.unpolishedHits = counts.unpolished;
        frame.metadata = sceneMetadata(scene);
        frame.metadata["renderer"] = "reference";
        frame.metadata["base"] = options.base == Base::Proxy ? "proxy" : "limit";
        addCertificate(stats.certificate, frame.metadata);
        frame.metadata["micro_triangles"] = fmt::format("{}", stats.microTriangles);
        for (size_t i = 0; i < meshes.size(); ++i)
            frame.metadata[fmt::format("object.{}.rate", i + 1)] = fmt::format("{}", stats.objects[i].rate);
        return frame;
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
