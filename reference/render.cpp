#include "render.h"

#include "../scenes/displaced_surface.h"
#include "embree.h"
#include "resolve_hit.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>

namespace plumbline {

namespace {

// Pixels traced before their hits are resolved: bounds memory, and still makes long runs of hits on one
// patch.
constexpr size_t kBandPixels = size_t(1) << 18;

// A shadow ray starts this far off its micro-triangle, as a fraction of the largest coordinate in play:
// vertices, the ray's origin and Embree's edge tests are each rounded to 2^-24 of it, eight times over with
// room to spare.
constexpr double kShadowOffsetFraction = 0x1p-20;

struct PixelHit {
    uint32_t pixel;
    uint32_t object;
    uint32_t patch;
    Vec3 position;
    Vec3 facetNormal;
    double u, v;
};

class FrameTracer {
  public:
    FrameTracer(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree)
        : scene_(scene), objects_(objects), embree_(embree), rays_(scene.camera),
          frame_(scene.camera.width, scene.camera.height) {
        for (const char* name :
             {"R", "G", "B", "A", "Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S", "st.T", "id"})
            channels_.push_back(frame_.add(name).data());
        for (const Light& light : scene.lights)
            shadows_.push_back(frame_.add(shadowChannel(light.name)).data());
        for (const TracedObject& object : objects)
            for (const Vec3f& position : object.mesh->positionsWorld)
                largestCoordinate_ = std::max(
                    {largestCoordinate_, std::abs(position.x), std::abs(position.y), std::abs(position.z)});
        fillBackground();
    }

    Frame trace(RayCounts& counts) {
        for (size_t first = 0; first < frame_.pixelCount(); first += kBandPixels) {
            const size_t count = std::min(kBandPixels, frame_.pixelCount() - first);
            std::vector<PixelHit> hits = traceBand(first, count);
            counts.camera += count;
            // Runs of hits on one patch share its set-up.
            tbb::parallel_sort(hits.begin(), hits.end(), [](const PixelHit& a, const PixelHit& b) {
                return std::tie(a.object, a.patch, a.pixel) < std::tie(b.object, b.patch, b.pixel);
            });
            counts.shadow += shadeBand(hits);
        }
        return std::move(frame_);
    }

  private:
    enum Plane { R, G, B, A, Z, PX, PY, PZ, NX, NY, NZ, S, T, Id };

    void fillBackground() {
        for (int k = 0; k < 3; ++k)
            std::fill_n(channels_[static_cast<size_t>(R + k)], frame_.pixelCount(),
                        static_cast<float>(scene_.background[k]));
    }

    /// Camera rays of pixels [first, first + count); hits in the order of pixels.
    std::vector<PixelHit> traceBand(size_t first, size_t count) const {
        std::vector<PixelHit> hits(count);
        std::vector<uint8_t> covered(count, 0);
        tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 1024),
                          [&](const tbb::blocked_range<size_t>& range) {
                              const FlushDenormals flush;
                              for (size_t i = range.begin(); i < range.end(); ++i)
                                  covered[i] = tracePixel(first + i, hits[i]);
                          });
        size_t kept = 0;
        for (size_t i = 0; i < count; ++i)
            if (covered[i]) hits[kept++] = hits[i];
        hits.resize(kept);
        return hits;
    }

    bool tracePixel(size_t pixel, PixelHit& result) const {
        const size_t width = static_cast<size_t>(frame_.width());
        const Ray ray =
            rays_.ray(static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5);
        const auto hit = embree_.intersect(ray.origin, ray.direction);
        if (!hit) return false;
        const TracedObject& object = objects_[hit->object];
        const MicroGrid& grid = object.mesh->grids[hit->grid];
        const ResolvedHit resolved = resolveHit(*object.mesh, grid, hit->u, hit->v, hit->distance, ray);
        result = {static_cast<uint32_t>(pixel), hit->object,   grid.patch,   resolved.position,
                  resolved.facetNormal,         resolved.uv.x, resolved.uv.y};
        return true;
    }

    /// Writes the pixels of all hits; returns the number of shadow rays.
    uint64_t shadeBand(const std::vector<PixelHit>& hits) {
        std::atomic<uint64_t> shadowRays = 0;
        tbb::parallel_for(
            tbb::blocked_range<size_t>(0, hits.size(), 1024), [&](const tbb::blocked_range<size_t>& range) {
                const FlushDenormals flush;
                std::optional<BaseSurface::Evaluator> evaluator;
                const PixelHit* previous = nullptr;
                uint64_t rays = 0;
                for (size_t i = range.begin(); i < range.end(); ++i) {
                    const PixelHit& hit = hits[i];
                    if (!previous || previous->object != hit.object)
                        evaluator.emplace(*objects_[hit.object].surface);
                    if (!previous || previous->object != hit.object || previous->patch != hit.patch)
                        evaluator->setPatch(static_cast<int>(hit.patch));
                    previous = &hit;
                    rays += shade(hit, *evaluator);
                }
                shadowRays += rays;
            });
        return shadowRays;
    }

    /// Writes one pixel; returns the number of shadow rays.
    uint64_t shade(const PixelHit& hit, const BaseSurface::Evaluator& evaluator) {
        const SceneObject& object = *objects_[hit.object].object;
        const DisplacedSample surface =
            displace(evaluator.sample(hit.u, hit.v), object.relief ? &*object.relief : nullptr);
        const Vec3 toCamera = rays_.towardsCamera(hit.position);
        // The side seen is the facet's: at a grazing edge the true normal can lean away from a camera the facet faces.
        const Vec3 facing = glm::dot(hit.facetNormal, toCamera) < 0 ? -surface.normal : surface.normal;

        uint64_t shadowRays = 0;
        double light = kAmbient;
        for (size_t i = 0; i < scene_.lights.size(); ++i) {
            const LightSample sample = sampleLight(scene_.lights[i], hit.position);
            const double cosine = glm::dot(facing, sample.toLightWorld);
            bool shadow = cosine <= 0;
            if (!shadow) {
                shadow = castShadow(hit, sample);
                ++shadowRays;
            }
            shadows_[i][hit.pixel] = shadow ? 1.0f : 0.0f;
            if (!shadow) light += cosine;
        }
        const Vec3 color = object.colorAt(surface.st) * light;
        write(hit.pixel, R, color);
        write(hit.pixel, PX, hit.position);
        write(hit.pixel, NX, surface.normal);
        channels_[A][hit.pixel] = 1;
        channels_[Z][hit.pixel] = static_cast<float>(rays_.planarDepth(hit.position));
        channels_[S][hit.pixel] = static_cast<float>(surface.st.x);
        channels_[T][hit.pixel] = static_cast<float>(surface.st.y);
        channels_[Id][hit.pixel] = static_cast<float>(hit.object + 1);
        return shadowRays;
    }

    /// The ray leaves on the side of the micro-triangle where the light is, so that a facet which turns away
    /// from a light the true surface faces doesn't shadow itself.
    bool castShadow(const PixelHit& hit, const LightSample& light) const {
        const double side = glm::dot(hit.facetNormal, light.toLightWorld) < 0 ? -1 : 1;
        const double reach =
            std::max(double(largestCoordinate_), std::isinf(light.distance) ? 0 : light.distance);
        const Vec3 origin = hit.position + hit.facetNormal * (side * kShadowOffsetFraction * reach);
        return embree_.occluded(origin, light.toLightWorld, static_cast<float>(light.distance));
    }

    void write(uint32_t pixel, Plane first, const Vec3& value) {
        for (int k = 0; k < 3; ++k)
            channels_[static_cast<size_t>(first + k)][pixel] = static_cast<float>(value[k]);
    }

    const Scene& scene_;
    const std::vector<TracedObject>& objects_;
    const EmbreeScene& embree_;
    CameraRays rays_;
    Frame frame_;
    std::vector<float*> channels_, shadows_;
    float largestCoordinate_ = 0;
};

} // namespace

Frame renderFrame(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree,
                  RayCounts& counts) {
    return FrameTracer(scene, objects, embree).trace(counts);
}

} // namespace plumbline
