// The one definition of the displaced surface:
//
//     P(u,v) = S(u,v) + n(u,v) * (offset - depth * d(st(u,v))),     st = tile * uv + uvOffset
//
// World space. Without a relief P = S.
//
// S and n are the limit surface's, or, on the proxy base, those of the triangles the real-time module draws: pushed out by
// `offset` at their vertices, with the vertices' normals interpolated linearly and renormalised. There the offset is in S:
//
//     P = S' + n * (-depth * d(st)),     S' = S + n * offset at the vertices, linear in between
//
// which is the P above at the vertices; in between, n times offset isn't linear, and the triangles' is meant.
#pragma once

#include "base_surface.h"
#include "scene.h"

namespace plumbline {

/// The object's base in world space. Throws InputError if it has a relief and its mesh no uvs.
std::unique_ptr<BaseSurface> makeBaseSurface(const SceneObject& object, Base base = Base::Limit);

/// The relief to displace that base with: the object's own, for the proxy with offset 0; none if the object has none.
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

/// Signed distance along n: offset - depth * d(st); 0 without a relief.
double displacement(const Vec2& st, const Relief* relief);

DisplacedSample displace(const BaseSample& base, const Relief* relief);

} // namespace plumbline
