// The polygon proxy the real-time module draws: the limit surface sampled at `proxyRate` segments per control
// edge, pushed out by the relief's offset, along the normals or the relief's axis. World space throughout.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/quadric_fit.h"

namespace plumbline {

struct ProxyVertex {
    Vec3 position; // on the limit surface + k * offset (displaced_surface.h)
    Vec3 normal;   // unit, of the limit surface
    /// dS/ds and dS/dt of the limit surface, per unit of the tiled st: tangents times the mapping scales sx,
    /// sy. Not necessarily at a right angle to each other; zero where the map from st to space is singular.
    Vec3 positionS;
    Vec3 positionT;
    Vec2 st; // tiled, unwrapped
    Vec2 uv; // of the control mesh, not tiled; zero if it has none
    /// Number of the place of the surface it stands on, below ProxyMesh::placeCount: vertices split there
    /// share it, and their position.
    size_t place = 0;
    /// Quadrics that bend like the proxy here, x along positionS, y along positionT: fitted to the one-ring
    /// (all vertices that share a facet); and that of the surface the vertices stand on, the limit surface
    /// pushed out by the offset (of a polygon mesh, Scheme::None: of its interpolated normals). 0 where the
    /// map from st to space is singular.
    RingFit ringQuadric;
    QuadricCoefficients limitQuadric;
};

struct ProxyMesh {
    std::vector<ProxyVertex> vertices; // split where texture coordinates are
    std::vector<unsigned> triangles;   // 3 indices each, counter-clockwise seen from outside
    size_t placeCount = 0;
};

/// Throws InputError if the object has a relief and its mesh no uvs.
ProxyMesh buildProxyMesh(const SceneObject& object);

/// The same triangles as a control mesh for Scheme::None, in world space: one point a place, so that it
/// closes where the proxy does; the proxy's own normals; the object's uvs, not tiled, if it has any.
ControlMesh proxyPolygons(const SceneObject& object);

} // namespace plumbline
