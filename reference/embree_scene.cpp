#include "embree_scene.h"

#include "../scenes/error.h"
#include "embree.h"

#include <fmt/format.h>

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

} // namespace

struct EmbreeScene::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    explicit Impl(const std::vector<MicroMesh>& meshes) {
        // The low bits of a hit depend on the instruction set: one is pinned, so that machines agree.
        device = rtcNewDevice("isa=avx2");
        if (!device) fail(rtcGetDeviceError(nullptr), "no device");
        scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        for (const MicroMesh& mesh : meshes)
            attach(mesh);
        rtcCommitScene(scene);
        check(device);
    }
    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void attach(const MicroMesh& mesh) {
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
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        check(device);
    }
};

EmbreeScene::EmbreeScene(const std::vector<MicroMesh>& meshes) : impl_(std::make_unique<Impl>(meshes)) {}
EmbreeScene::~EmbreeScene() = default;

std::optional<EmbreeScene::Hit> EmbreeScene::intersect(const Vec3f& origin, const Vec3f& direction) const {
    RTCRayHit rayHit{};
    rayHit.ray.org_x = origin.x;
    rayHit.ray.org_y = origin.y;
    rayHit.ray.org_z = origin.z;
    rayHit.ray.dir_x = direction.x;
    rayHit.ray.dir_y = direction.y;
    rayHit.ray.dir_z = direction.z;
    rayHit.ray.tfar = kInfinityF;
    rayHit.ray.mask = ~0u;
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embreeIntersect(impl_->scene, rayHit);
    if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{rayHit.hit.geomID, rayHit.hit.primID, rayHit.hit.u, rayHit.hit.v, rayHit.ray.tfar};
}

bool EmbreeScene::occluded(const Vec3f& origin, const Vec3f& direction, float maxDistance) const {
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = maxDistance;
    ray.mask = ~0u;
    embreeOccluded(impl_->scene, ray);
    return ray.tfar < 0;
}

} // namespace plumbline
