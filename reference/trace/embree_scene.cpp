#include "reference/trace/embree_scene.h"

#include "reference/trace/embree.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {

namespace {

[[noreturn]] void fail(RTCError code, const char* message) {
    const std::string what =
        fmt::format("Embree: {} (error {})", message ? message : "no message", static_cast<int>(code));
    throw MachineError("reference", what, {},
                       code == RTC_ERROR_OUT_OF_MEMORY ? "give a smaller --memory or --rate" : "");
}

void check(RTCDevice device) {
    const RTCError code = rtcGetDeviceError(device);
    if (code != RTC_ERROR_NONE) fail(code, "building the scene failed");
}

// Leaks at vertices. In ROBUST mode, the sign of a Pluecker product determines on which side of an edge a ray
// passes. Both triangles of the edge compute the same number up to its sign, so no ray passes between them.
// Around a vertex, however, the products of the fan's edges are rounded independently. For a ray within
// rounding of the vertex, the signs may be inconsistent, and then no triangle of the fan is hit.
//
// So a ray without a hit is retraced with pairs of parallel rays on opposite sides of it. If both rays of a
// pair hit something, so does the original ray. A single hit isn't sufficient: next to a silhouette, one ray
// of the pair hits the surface, and the silhouette would grow by the distance between the two.

// The offset to each side, as a fraction of the largest coordinate involved. Differences between vertices and
// the ray's origin, and their products, have relative errors of about 2^-24 each, about six of which are
// summed. Of 10^6 rays aimed at vertices (tests/reference/trace/leak_test.cpp), 200 still leak with an offset
// of 2^-24, one or two with 2^-22 and none with 2^-21 (measured).
constexpr float kShiftFraction = 0x1p-20f;

// Angle of the first pair in the plane orthogonal to the ray, chosen so that rows of vertices aren't likely
// to have this direction.
constexpr float kPairCosine = 0.5403023f, kPairSine = 0.8414710f; // of 1 radian

float largestCoordinate(const Vec3f& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Origins of the offset rays. [0] and [1] are opposite each other, as are [2] and [3], orthogonal to them.
std::array<Vec3f, 4> originsBeside(const Vec3f& origin, const Vec3f& direction, float shift) {
    // Duff et al. 2017, Building an Orthonormal Basis, Revisited.
    const float sign = std::copysign(1.0f, direction.z);
    const float a = -1 / (sign + direction.z), b = direction.x * direction.y * a;
    const Vec3f across(1 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x);
    const Vec3f along(b, sign + direction.y * direction.y * a, -direction.y);
    const Vec3f first = shift * (kPairCosine * across + kPairSine * along);
    const Vec3f second = shift * (kPairCosine * along - kPairSine * across);
    return {origin + first, origin - first, origin + second, origin - second};
}

} // namespace

struct EmbreeScene::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    LeakGuard guard;
    float largestCoordinate = 0; // of all vertices

    Impl(const std::vector<MicroMesh>& meshes, LeakGuard guardGiven, const std::vector<bool>& culled)
        : guard(guardGiven) {
        // The low bits of a hit depend on the instruction set, so it is fixed to give the same results on all
        // machines.
        device = rtcNewDevice("isa=avx2");
        if (!device) fail(rtcGetDeviceError(nullptr), "no device");
        scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        for (size_t i = 0; i < meshes.size(); ++i)
            attach(meshes[i], !culled.empty() && culled[i]);
        rtcCommitScene(scene);
        check(device);
        RTCBounds bounds;
        rtcGetSceneBounds(scene, &bounds);
        largestCoordinate =
            std::max(plumbline::largestCoordinate({bounds.lower_x, bounds.lower_y, bounds.lower_z}),
                     plumbline::largestCoordinate({bounds.upper_x, bounds.upper_y, bounds.upper_z}));
    }
    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void attach(const MicroMesh& mesh, bool culled) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_GRID);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.positionsWorld.data(), 0, sizeof(Vec3f), mesh.positionsWorld.size());
        auto* grids = static_cast<RTCGrid*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), mesh.grids.size()));
        check(device);
        for (size_t i = 0; i < mesh.grids.size(); ++i) {
            const MicroGrid& grid = mesh.grids[i];
            grids[i] = {grid.firstVertex, grid.columns, grid.columns, grid.rows};
        }
        if (culled) embreeSkipBacks(geometry);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        check(device);
    }

    /// Embree's result for one ray.
    struct Trace {
        bool hit = false;
        bool outerSide = false; // the facet faces the ray
        Hit at{};
    };
    Trace trace(const Vec3f& origin, const Vec3f& direction, unsigned rayId) const {
        RTCRayHit rayHit{};
        rayHit.ray = makeRay(origin, direction, kInfinityF);
        rayHit.ray.id = rayId;
        rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        embreeIntersect(scene, rayHit);
        const RTCHit& hit = rayHit.hit;
        if (hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        const bool outerSide = glm::dot(Vec3f(hit.Ng_x, hit.Ng_y, hit.Ng_z), direction) < 0;
        return {true, outerSide, {hit.geomID, hit.primID, hit.u, hit.v, rayHit.ray.tfar}};
    }

    /// The nearest hit; a ray that may have leaked is retraced.
    std::optional<Hit> nearest(const Vec3f& origin, const Vec3f& direction, unsigned rayId) const;

    bool blocked(const Vec3f& origin, const Vec3f& direction, float maxDistance) const {
        RTCRay ray = makeRay(origin, direction, maxDistance);
        embreeOccluded(scene, ray);
        return ray.tfar < 0;
    }

    std::array<Vec3f, 4> beside(const Vec3f& origin, const Vec3f& direction) const {
        return originsBeside(origin, direction,
                             kShiftFraction *
                                 std::max(largestCoordinate, plumbline::largestCoordinate(origin)));
    }

    static RTCRay makeRay(const Vec3f& origin, const Vec3f& direction, float maxDistance) {
        RTCRay ray{};
        ray.org_x = origin.x;
        ray.org_y = origin.y;
        ray.org_z = origin.z;
        ray.dir_x = direction.x;
        ray.dir_y = direction.y;
        ray.dir_z = direction.z;
        ray.tfar = maxDistance;
        ray.mask = ~0u;
        return ray;
    }
};

EmbreeScene::EmbreeScene(const std::vector<MicroMesh>& meshes, LeakGuard guard,
                         const std::vector<bool>& culled)
    : impl_(std::make_unique<Impl>(meshes, guard, culled)) {}
EmbreeScene::~EmbreeScene() = default;

float EmbreeScene::largestCoordinate() const {
    return impl_->largestCoordinate;
}

std::optional<EmbreeScene::Hit> EmbreeScene::Impl::nearest(const Vec3f& origin, const Vec3f& direction,
                                                           unsigned rayId) const {
    const Trace straight = trace(origin, direction, rayId);
    const auto result = [](const Trace& trace) {
        return trace.hit ? std::optional<Hit>(trace.at) : std::nullopt;
    };
    // A ray that leaks into a closed surface hits its far wall from inside.
    if (straight.outerSide || guard == LeakGuard::Off) return result(straight);
    const auto inTheWay = [&](const Trace& side) {
        return side.hit && (!straight.hit || (side.outerSide && side.at.distance < straight.at.distance));
    };
    const std::array<Vec3f, 4> origins = beside(origin, direction);
    const Trace first = trace(origins[0], direction, rayId);
    if (!inTheWay(first)) return result(straight);
    if (inTheWay(trace(origins[1], direction, rayId))) return result(first);
    // Next to a silhouette, or one ray of the pair has leaked too.
    const Trace second = trace(origins[2], direction, rayId);
    return result(inTheWay(second) && inTheWay(trace(origins[3], direction, rayId)) ? second : straight);
}

std::optional<EmbreeScene::Hit> EmbreeScene::intersect(const Vec3f& origin, const Vec3f& direction) const {
    return impl_->nearest(origin, direction, 0);
}

std::optional<EmbreeScene::Hit> EmbreeScene::intersectSeen(const Vec3f& origin,
                                                           const Vec3f& direction) const {
    return impl_->nearest(origin, direction, kSkipsBacks);
}

bool EmbreeScene::occluded(const Vec3f& origin, const Vec3f& direction, float maxDistance) const {
    if (impl_->blocked(origin, direction, maxDistance)) return true;
    if (impl_->guard == LeakGuard::Off) return false;
    const std::array<Vec3f, 4> origins = impl_->beside(origin, direction);
    const auto blocked = [&](size_t k) { return impl_->blocked(origins[k], direction, maxDistance); };
    return blocked(0) && (blocked(1) || (blocked(2) && blocked(3)));
}

} // namespace plumbline
