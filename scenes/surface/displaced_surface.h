// The definition of the displaced surface, used by both renderers:
//
//     P(u,v) = S(u,v) + k(u,v) * (offset - depth * d(st(u,v))),     st = tile * uv + uvOffset
//
// where k is n, the unit normal of the base, or a constant unit axis of the object (Relief::axisWorld). World
// space. Without a relief P = S.
//
// S and n are those of the limit surface, or, for the proxy base, those of the triangles drawn by the
// real-time renderer: their vertices are moved by `offset`, and vertex normals are interpolated linearly and
// renormalized. There the offset is part of S:
//
//     P = S' + k * (-depth * d(st)),     S' = S + k * offset at the vertices, linear in between
//
// This equals the P above at the vertices. Between them, n * offset isn't linear, so the two differ; the
// triangles define the surface. With a constant axis both are equal everywhere.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

namespace plumbline {

/// The object's base surface in world space. Throws InputError if the object has a relief but its mesh has no
/// uvs.
std::unique_ptr<BaseSurface> makeBaseSurface(const SceneObject& object, Base base = Base::Limit);

/// The relief that displaces this base: the object's, with offset 0 for the proxy base; none if the object
/// has none.
std::optional<Relief> reliefOn(const SceneObject& object, Base base);

struct DisplacedSample {
    Vec3 position;             // world
    Vec3 positionU, positionV; // derivatives of P with respect to the patch's u and v
    Vec3 normal;               // world, unit: P_u x P_v normalized; the base's normal where it vanishes
    Vec2 st;                   // tiled, unwrapped
    double reliefDepth;        // d; 0 without a relief
};

/// Texture coordinates of a base sample: tiled, or the plain uv without a relief.
Vec2 textureCoordinates(const BasePoint& base, const Relief* relief);

/// k at a base point: the axis, or n; n without a relief.
Vec3 reliefDirection(const BasePoint& base, const Relief* relief);

/// k with its derivatives with respect to the patch's u and v, which are 0 for an axis.
struct ReliefDirection {
    Vec3 along, alongU, alongV;
};
ReliefDirection sampleReliefDirection(const BaseSample& base, const Relief* relief);

/// The components of S_u and S_v orthogonal to k. If k is n, they are S_u and S_v unchanged.
struct AcrossRelief {
    Vec3 byU, byV;
};
AcrossRelief tangentsAcross(const BaseSample& base, const Relief* relief);

/// Signed distance along k: offset - depth * d(st); 0 without a relief.
double displacement(const Vec2& st, const Relief* relief);

DisplacedSample displace(const BaseSample& base, const Relief* relief);

} // namespace plumbline
