#include "reference/trace/render.h"

#include "reference/trace/embree.h"
#include "reference/trace/facing.h"
#include "reference/trace/refine_hit.h"
#include "reference/trace/resolve_hit.h"
#include "scenes/surface/displaced_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace plumbline {

namespace {

// Pixels traced before their hits are resolved. This bounds memory and still gives long runs of hits on the
// same patch.
constexpr size_t kBandPixels = size_t(1) << 18;

// Minimum offset of a shadow ray's origin from the surface, to avoid self-intersection, as a fraction of the
// largest coordinate involved. Vertices, the ray's origin and Embree's edge tests each have rounding errors
// of 2^-24; this is 16 times that.
constexpr double kShadowOffsetFraction = 0x1p-20;

// The true surface is searched within this multiple of the grid's error bound, measured along the normal from
// the micro-triangle. The distance along the ray is larger, up to that of a ray at kGrazingCosine to the
// facet.
constexpr double kRefineReach = 2;
constexpr double kGrazingCosine = 0.02;

// An occluder farther away than this multiple of the error's reach can't be a self-intersection caused by the
// tessellation error.
constexpr double kBelowReach = 4;

// Maximum number of surfaces behind the visible point that are examined for another object; those of the same
// object are skipped.
constexpr int kSheetsPassed = 4;

// Border cells of a torn patch that the wall to its neighbor may shadow or hide: the welded cell and the next
// one.
constexpr double kTearCells = 2;

struct PixelHit {
    uint32_t pixel;
    uint32_t object, grid;
    PatchPlace place;
    Vec3 position; // on the micro-triangle
    Vec3 facetNormal;
    double distance;
};

class FrameTracer {
  public:
    FrameTracer(const Scene& scene, const std::vector<TracedObject>& objects, const EmbreeScene& embree)
        : scene_(scene), objects_(objects), embree_(embree), rays_(scene.camera),
          frame_(scene.camera.width, scene.camera.height), largestCoordinate_(embree.largestCoordinate()) {
        for (const char* name : {"R", "G", "B", "A", "Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S",
                                 "st.T", "id", "facing"})
            channels_.push_back(frame_.add(name).data());
        for (const Light& light : scene.lights)
            shadows_.push_back(frame_.add(shadowChannel(light.name)).data());
        for (const TracedObject& object : objects) {
            neighbors_.emplace_back(*object.surface);
            for (const MicroGrid& grid : object.mesh->grids)
                largestError_ = std::max(largestError_, grid.errorWorld);
        }
        evidence_.errorWorld.assign(frame_.pixelCount(), 0);
        evidence_.face.assign(frame_.pixelCount(), 0);
        evidence_.ambiguous.assign(frame_.pixelCount(), 0);
        evidence_.otherObject.assign(frame_.pixelCount(), 0);
        evidence_.shadowBy.assign(scene.lights.size(), std::vector<uint8_t>(frame_.pixelCount(), 0));
        fillBackground();
    }

    TracedFrame trace() {
        for (size_t first = 0; first < frame_.pixelCount(); first += kBandPixels) {
            const size_t count = std::min(kBandPixels, frame_.pixelCount() - first);
            std::vector<PixelHit> hits = traceBand(first, count);
            // Consecutive hits on the same patch share its setup.
            tbb::parallel_sort(hits.begin(), hits.end(), [](const PixelHit& a, const PixelHit& b) {
                return std::tie(a.object, a.place.patch, a.pixel) <
                       std::tie(b.object, b.place.patch, b.pixel);
            });
            shadeBand(hits);
        }
        return {std::move(frame_), std::move(evidence_)};
    }

  private:
    enum Plane { R, G, B, A, Z, PX, PY, PZ, NX, NY, NZ, S, T, Id, Facing };

    void fillBackground() {
        for (int k = 0; k < 3; ++k)
            std::fill_n(item(channels_, R + k), frame_.pixelCount(),
                        static_cast<float>(scene_.background[k]));
    }

    Ray rayOf(size_t pixel) const { return rays_.ray(pixelCenter(pixel, lengthOf(frame_.width()))); }

    /// Traces the camera rays of pixels [first, first + count); hits are in pixel order.
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
        const Ray ray = rayOf(pixel);
        const auto hit = embree_.intersectSeen(ray.origin, ray.direction);
        if (!hit) return false;
        const MicroMesh& mesh = *objects_[hit->object].mesh;
        const MicroGrid& grid = mesh.grids[hit->grid];
        const ResolvedHit resolved = resolveHit(mesh, grid, hit->u, hit->v, hit->distance, ray);
        result = {static_cast<uint32_t>(pixel),
                  hit->object,
                  hit->grid,
                  {static_cast<int>(grid.patch), resolved.uv},
                  resolved.position,
                  resolved.facetNormal,
                  resolved.distance};
        return true;
    }

    /// Writes the pixels of all hits.
    void shadeBand(const std::vector<PixelHit>& hits) {
        tbb::parallel_for(tbb::blocked_range<size_t>(0, hits.size(), 1024),
                          [&](const tbb::blocked_range<size_t>& range) {
                              const FlushDenormals flush;
                              std::optional<HitRefiner> refiner;
                              const PixelHit* previous = nullptr;
                              for (size_t i = range.begin(); i < range.end(); ++i) {
                                  const PixelHit& hit = hits[i];
                                  if (!previous || previous->object != hit.object)
                                      refiner.emplace(*objects_[hit.object].surface,
                                                      objects_[hit.object].relief, neighbors_[hit.object]);
                                  previous = &hit;
                                  shade(hit, *refiner);
                              }
                          });
    }

    double errorOf(const PixelHit& hit) const {
        return objects_[hit.object].mesh->grids[hit.grid].errorWorld;
    }

    /// The surface at a hit; if the hit can't be refined, the surface at the micro-triangle's (u, v).
    SurfaceSample surfaceAt(const PixelHit& hit, HitRefiner& refiner, double side) {
        const Ray ray = rayOf(hit.pixel);
        const double cosine = std::max(std::abs(glm::dot(hit.facetNormal, ray.direction)), kGrazingCosine);
        const double reach = kRefineReach * errorOf(hit) / cosine;
        if (const auto refined = refiner.refine(ray, hit.place, hit.distance, reach)) {
            if (facesThroughout(hit, refined->sample, -ray.direction, side)) return refined->sample;
            evidence_.ambiguous[hit.pixel] = 1;
            return refiner.first(ray, *refined, reach).sample;
        }
        evidence_.ambiguous[hit.pixel] = 1;
        SurfaceSample sample = refiner.sampleAt(hit.place);
        sample.displaced.position = hit.position;
        return sample;
    }

    /// Bound on the displacement of a hit along the ray by a grid's error.
    static double alongRay(double error, const Vec3& facetNormal, const Ray& ray) {
        return error / std::max(std::abs(glm::dot(facetNormal, ray.direction)), kGrazingCosine);
    }

    /// Whether another object is behind the visible micro-triangle within the errors of both. Surfaces of the
    /// same object in between are skipped.
    bool isCloseToAnother(const PixelHit& hit) const {
        const Ray ray = rayOf(hit.pixel);
        const double own = alongRay(errorOf(hit), hit.facetNormal, ray);
        const double farthest = own + largestError_ / kGrazingCosine;
        double from = hit.distance;
        for (int sheet = 0; sheet < kSheetsPassed; ++sheet) {
            const double start = from + kShadowOffsetFraction * (largestCoordinate_ + from);
            const double left = hit.distance + farthest - start;
            if (!(left > 0) || !embree_.occluded(ray.at(start), ray.direction, static_cast<float>(left)))
                return false;
            const auto next = embree_.intersectSeen(ray.at(start), ray.direction);
            if (!next) return false;
            if (next->object == hit.object) {
                from = start + next->distance;
                continue;
            }
            const MicroMesh& mesh = *objects_[next->object].mesh;
            const MicroGrid& grid = mesh.grids[next->grid];
            const Ray onwards{ray.at(start), ray.direction};
            const ResolvedHit other = resolveHit(mesh, grid, next->u, next->v, next->distance, onwards);
            return start + other.distance - hit.distance <=
                   own + alongRay(grid.errorWorld, other.facetNormal, ray);
        }
        return false;
    }

    /// Whether the hit is in the border cells of a patch at a torn edge.
    bool isBesideTear(const PixelHit& hit) const {
        const MicroMesh& mesh = *objects_[hit.object].mesh;
        if (!mesh.grids[hit.grid].torn) return false;
        const PatchLattice& lattice = mesh.lattices[mesh.grids[hit.grid].patch];
        const Vec2 uv = hit.place.uv;
        // Along a side coarser than the lattice, cells are as wide as the side's segments.
        const auto widest = [&](int side, int other, int cells) {
            const int segments = std::min(item(lattice.sides, side), item(lattice.sides, other));
            return std::max(kTearCells / cells, 1.0 / segments / 2);
        };
        const double nearU = widest(0, 2, lattice.columns), nearV = widest(1, 3, lattice.rows);
        if (lattice.triangular) return std::min({uv.x, uv.y, 1 - uv.x - uv.y}) < std::max(nearU, nearV);
        return std::min(uv.x, 1 - uv.x) < nearU || std::min(uv.y, 1 - uv.y) < nearV;
    }

    /// Whether the surface is facing `toward` with the same side throughout the error's reach, for a
    /// direction with this cosine to the facet.
    bool facesThroughout(const PixelHit& hit, const SurfaceSample& surface, const Vec3& toward,
                         double side) const {
        if (isBesideTear(hit)) return false;
        const double cosine = glm::dot(hit.facetNormal, toward);
        return plumbline::facesThroughout(surface.base, objects_[hit.object].relief,
                                          reachAlongSurface(errorOf(hit), cosine), toward, side);
    }

    /// Writes one pixel.
    void shade(const PixelHit& hit, HitRefiner& refiner) {
        const SceneObject& object = *objects_[hit.object].object;
        // The visible side is that of the facet: near a silhouette, the true normal may face away from the
        // camera although the facet is front-facing.
        const bool away = glm::dot(hit.facetNormal, rays_.towardCamera(hit.position)) < 0;
        const double side = away && object.cull != Cull::Back ? -1 : 1;
        const SurfaceSample sampled = surfaceAt(hit, refiner, side);
        const DisplacedSample& surface = sampled.displaced;
        evidence_.errorWorld[hit.pixel] = static_cast<float>(errorOf(hit));
        evidence_.face[hit.pixel] = objects_[hit.object].surface->patch(hit.place.patch).face;

        if (objects_.size() > 1 && isCloseToAnother(hit)) evidence_.otherObject[hit.pixel] = 1;

        const Vec3 color = object.colorAt(surface.st) * lightAt(hit, sampled, side);
        write(hit.pixel, R, color);
        write(hit.pixel, PX, surface.position);
        write(hit.pixel, NX, surface.normal);
        channels_[A][hit.pixel] = 1;
        channels_[Z][hit.pixel] = static_cast<float>(rays_.planarDepth(surface.position));
        channels_[S][hit.pixel] = static_cast<float>(surface.st.x);
        channels_[T][hit.pixel] = static_cast<float>(surface.st.y);
        channels_[Id][hit.pixel] = static_cast<float>(hit.object + 1);
        channels_[Facing][hit.pixel] = static_cast<float>(side);
    }

    /// The light received by the visible side from all lights. Writes the pixel's shadow channels.
    double lightAt(const PixelHit& hit, const SurfaceSample& surface, double side) {
        const Vec3 position = surface.displaced.position, facing = side * surface.displaced.normal;
        double received = kAmbient;
        for (size_t i = 0; i < scene_.lights.size(); ++i) {
            const LightSample light = sampleLight(scene_.lights[i], position);
            const double cosine = glm::dot(facing, light.toLightWorld);
            bool shadow = cosine <= 0;
            if (!shadow) {
                const Ray ray = shadowRay(hit, position, facing, light);
                shadow = embree_.occluded(ray.origin, ray.direction, static_cast<float>(light.distance));
                const bool clear = shadow ? !startsBelow(hit, ray, side)
                                          : facesThroughout(hit, surface, light.toLightWorld, side);
                evidence_.shadowBy[i][hit.pixel] = clear ? FrameEvidence::kRay : FrameEvidence::kNearRay;
            }
            shadows_[i][hit.pixel] = shadow ? 1.0f : 0.0f;
            if (!shadow) received += cosine;
        }
        return received;
    }

    /// The shadow ray starts at the true surface on the light's side, offset by the error bound so that it
    /// begins above the micro-triangles. This prevents self-shadowing by the tessellation.
    Ray shadowRay(const PixelHit& hit, const Vec3& position, const Vec3& facing,
                  const LightSample& light) const {
        const double reach =
            std::max(double(largestCoordinate_), std::isinf(light.distance) ? 0 : light.distance);
        return {position + facing * (errorOf(hit) + kShadowOffsetFraction * reach), light.toLightWorld};
    }

    /// Whether an occluded shadow ray is occluded only because it starts below nearby micro-triangles that
    /// are too high: its first hit is on their inner side, within the distance explained by their error.
    bool startsBelow(const PixelHit& hit, const Ray& ray, double side) const {
        const auto blocker = embree_.intersect(ray.origin, ray.direction);
        if (!blocker || blocker->object != hit.object) return false;
        const MicroMesh& mesh = *objects_[hit.object].mesh;
        const MicroGrid& grid = mesh.grids[blocker->grid];
        const ResolvedHit resolved = resolveHit(mesh, grid, blocker->u, blocker->v, blocker->distance, ray);
        const double outwards = side * glm::dot(resolved.facetNormal, ray.direction);
        const double error = std::max(double(grid.errorWorld), errorOf(hit));
        return outwards > 0 &&
               resolved.distance <=
                   kBelowReach * reachAlongSurface(error, glm::dot(hit.facetNormal, ray.direction));
    }

    void write(uint32_t pixel, Plane first, const Vec3& value) {
        for (int k = 0; k < 3; ++k)
            item(channels_, first + k)[pixel] = static_cast<float>(value[k]);
    }

    const Scene& scene_;
    const std::vector<TracedObject>& objects_;
    const EmbreeScene& embree_;
    CameraRays rays_;
    Frame frame_;
    FrameEvidence evidence_;
    std::vector<PatchNeighbors> neighbors_; // per object
    std::vector<float*> channels_, shadows_;
    float largestCoordinate_, largestError_ = 0;
};

} // namespace

TracedFrame traceFrame(const Scene& scene, const std::vector<TracedObject>& objects,
                       const EmbreeScene& embree) {
    return FrameTracer(scene, objects, embree).trace();
}

} // namespace plumbline
