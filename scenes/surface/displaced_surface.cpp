#include "scenes/surface/displaced_surface.h"

#include "scenes/core/error.h"
#include "scenes/surface/proxy_mesh.h"

#include <cassert>

namespace plumbline {

namespace {

/// Sums below this fraction of their terms have canceled.
constexpr double kCanceled = 0x1p-40;

/// The displaced normal where S_u x S_v is 0 and the displacement has the derivatives byU and byV: what is
/// left of P_u x P_v, a slope of the relief that the base's parametrization makes infinitely steep, or the
/// base's normal.
Vec3 singularNormal(const BaseSample& base, const Vec3& byU, const Vec3& byV) {
    const Vec3 sum = glm::cross(base.positionU, byV) + glm::cross(byU, base.positionV) + glm::cross(byU, byV);
    const double most = glm::length(base.positionU) * glm::length(byV) +
                        glm::length(byU) * glm::length(base.positionV) + glm::length(byU) * glm::length(byV);
    const double length = glm::length(sum);
    return length > kCanceled * most ? sum / length : base.normal;
}

} // namespace

std::unique_ptr<BaseSurface> makeBaseSurface(const SceneObject& object, Base base) {
    if (object.relief && !object.mesh.hasUvs())
        throw InputError(object.name, "the mesh '" + object.mesh.name + "' has no texture coordinates",
                         "uvs, because the object has a relief");
    if (base == Base::Proxy) return std::make_unique<BaseSurface>(proxyPolygons(object), Scheme::None);
    return std::make_unique<BaseSurface>(object.meshWorld(), object.scheme);
}

std::optional<Relief> reliefOn(const SceneObject& object, Base base) {
    std::optional<Relief> relief = object.relief;
    if (relief && base == Base::Proxy) relief->offset = 0;
    return relief;
}

Vec2 textureCoordinates(const BasePoint& base, const Relief* relief) {
    return relief ? relief->tile * base.uv + relief->uvOffset : base.uv;
}

Vec3 reliefDirection(const BasePoint& base, const Relief* relief) {
    return relief && relief->axisWorld ? *relief->axisWorld : base.normal;
}

ReliefDirection sampleReliefDirection(const BaseSample& base, const Relief* relief) {
    if (relief && relief->axisWorld) return {*relief->axisWorld, Vec3(0), Vec3(0)};
    return {base.normal, base.normalU, base.normalV};
}

AcrossRelief tangentsAcross(const BaseSample& base, const Relief* relief) {
    if (!relief || !relief->axisWorld) return {base.positionU, base.positionV};
    const Vec3& axis = *relief->axisWorld;
    return {base.positionU - axis * glm::dot(base.positionU, axis),
            base.positionV - axis * glm::dot(base.positionV, axis)};
}

double displacement(const Vec2& st, const Relief* relief) {
    return relief ? relief->offset - relief->depth * relief->map->depth(st) : 0.0;
}

DisplacedSample displace(const BaseSample& base, const Relief* relief) {
    const Vec2 st = textureCoordinates(base, relief);
    if (!relief) return {base.position, base.positionU, base.positionV, base.normal, st, 0.0};
    assert(relief->map);

    const HeightMap::Sample map = relief->map->sample(st);
    const double height = relief->offset - relief->depth * map.depth;
    const double heightU = -relief->depth * glm::dot(map.gradient, relief->tile * base.uvU);
    const double heightV = -relief->depth * glm::dot(map.gradient, relief->tile * base.uvV);
    const ReliefDirection k = sampleReliefDirection(base, relief);
    const Vec3 positionU = base.positionU + k.alongU * height + k.along * heightU;
    const Vec3 positionV = base.positionV + k.alongV * height + k.along * heightV;
    const Vec3 position = base.position + k.along * height;
    if (base.singular) {
        const Vec3 normal = singularNormal(base, k.alongU * height + k.along * heightU,
                                           k.alongV * height + k.along * heightV);
        return {position, positionU, positionV, normal, st, map.depth};
    }
    const Vec3 cross = glm::cross(positionU, positionV);
    const double length = glm::length(cross);
    return {position, positionU, positionV, length > 0 ? cross / length : base.normal, st, map.depth};
}

} // namespace plumbline
