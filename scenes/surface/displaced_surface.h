// The one definition of the displaced surface:
//
//     P(u,v) = S(u,v) + k(u,v) * (offset - depth * d(st(u,v))),     st = tile * uv + uvOffset
//
// with k = n, the unit normal of the base, or an axis of the object, one unit vector for all of it
// (Relief::axisWorld). World space. Without a relief P = S.
//
// S and n are the limit surface's, or, on the proxy base, those of the triangles the real-time module draws:
// pushed out by `offset` at their vertices, with the vertices' normals interpolated linearly and
// renormalized. There the offset is in S:
//
//     P = S' + k * (-depth * d(st)),     S' = S + k * offset at the vertices, linear in between
//
// which is the P above at the vertices; in between, n times offset isn't linear, and the triangles' is meant.
// Along an axis both are the same everywhere.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/base_surface.h"

namespace plumbline {

/// The object's base in world space. Throws InputError if it has a relief and its mesh no uvs.
std::unique_ptr<BaseSurface> makeBaseSurface(const SceneObject& object, Base base = Base::Limit);

/// The relief to displace that base with: the object's own, for the proxy with offset 0; none if the object
/// has none.
std::optional<Relief> reliefOn(const SceneObject& object, Base base);

struct DisplacedSample {
    Vec3 position;             // world
    Vec3 positionU, positionV; // derivatives of P by the patch's u and v
    Vec3 normal;               // world, unit, of P itself: P_u x P_v; the base's where that vanishes
    Vec2 st;                   // tiled, unwrapped
    double reliefDepth;        // d; 0 without a relief
};

/// Texture coordinates of a base sample: tiled, or the plain uv without a relief.
Vec2 textureCoordinates(const BasePoint& base, const Relief* relief);

/// k at a base point: the axis, or n; n without a relief.
Vec3 reliefDirection(const BasePoint& base, const Relief* relief);

/// k with its derivatives by the patch's u and v: those of n, or 0.
struct ReliefDirection {
    Vec3 along, alongU, alongV;
};
ReliefDirection sampleReliefDirection(const BaseSample& base, const Relief* relief);

/// S_u and S_v without their parts along k: how the foot of a point of P moves across k. The very S_u and S_v
/// where k is n.
struct AcrossRelief {
    Vec3 byU, byV;
};
AcrossRelief tangentsAcross(const BaseSample& base, const Relief* relief);

/// Signed distance along k: offset - depth * d(st); 0 without a relief.
double displacement(const Vec2& st, const Relief* relief);

DisplacedSample displace(const BaseSample& base, const Relief* relief);

} // namespace plumbline
