// The polygon proxy drawn by the real-time renderer: the limit surface sampled with `proxyRate` segments per
// control edge and moved by the relief's offset along the normals or the relief's axis. World space.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/quadric_fit.h"

namespace plumbline {

struct ProxyVertex {
    Vec3 position; // on the limit surface + k * offset (displaced_surface.h)
    Vec3 normal;   // unit, of the limit surface
    /// dS/ds and dS/dt of the limit surface, per unit of the tiled st: tangents times the mapping scales sx,
    /// sy. Not necessarily orthogonal; zero where the parametrization is singular.
    Vec3 positionS;
    Vec3 positionT;
    Vec2 st; // tiled, unwrapped
    Vec2 uv; // of the control mesh, not tiled; zero if it has none
    /// Index of the vertex's place on the surface, below ProxyMesh::placeCount. Vertices split at a texture
    /// seam share the place and the position.
    size_t place = 0;
    /// Quadrics that approximate the surface at the vertex, x along positionS and y along positionT.
    /// ringQuadric is fitted to the one-ring, that is, all vertices that share a facet. limitQuadric is
    /// computed from the derivatives of the limit surface displaced by the offset (for polygon meshes under
    /// Scheme::None, from the interpolated normals). 0 where the parametrization is singular.
    RingFit ringQuadric;
    QuadricCoefficients limitQuadric;
};

struct ProxyMesh {
    std::vector<ProxyVertex> vertices; // split at texture seams
    std::vector<unsigned> triangles;   // 3 indices each, counterclockwise seen from outside
    size_t placeCount = 0;
};

/// Throws InputError if the object has a relief but its mesh has no uvs.
ProxyMesh buildProxyMesh(const SceneObject& object);

/// The same triangles as a control mesh for Scheme::None, in world space, with one point per place so that it
/// is closed where the proxy is, the proxy's normals, and the object's untiled uvs if it has any.
ControlMesh proxyPolygons(const SceneObject& object);

} // namespace plumbline
