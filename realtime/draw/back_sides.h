// From where the back sides of a surface are seen, and the relief as it is seen from there. World space.
//
// The front hides the back of a closed surface from everywhere but its inside. There is nothing to hide the
// back of an open one.
#pragma once

#include "scenes/scene/scene.h"
#include "scenes/surface/proxy_mesh.h"

namespace plumbline {

/// A camera or a light.
struct Viewer {
    bool distant = false;
    Vec3 place{0}; // world; if distant: unit direction toward it
    /// Orthographic cameras see from a plane, and what it cuts from inside.
    bool fromPlane = false;
    Vec3 planePoint{0};

    static Viewer ofCamera(const Camera& camera);
    static Viewer ofLight(const Light& light);
};

/// Which viewers see back sides of an object's proxy that are to be drawn.
struct BackSides {
    bool toCamera = false; // as the object's Cull says
    bool toLight = false;  // any light: the sides that cast shadows don't depend on Cull
};
BackSides backSidesOf(const SceneObject& object, const ProxyMesh& proxy, const Scene& scene);

/// Whether the viewer is where a surface shows its back first: inside a closed one whose faces point outward,
/// outside of one whose faces point inward. For closed proxies.
bool seesBackFirst(const ProxyMesh& proxy, const Viewer& viewer);

/// A relief's map as it is from behind: all depths subtracted from 1.
HeightMap complementOf(const HeightMap& map);

} // namespace plumbline
