// The image plane of a camera or a light, in its own units ("pixels"), onto which world points are projected.
// World space, world units.
#pragma once

#include "scenes/core/math.h"
#include "scenes/scene/camera.h"

namespace plumbline {

/// The point or direction from which a surface is viewed.
struct Viewpoint {
    bool distant = false;
    Vec3 place{0}; // world; if distant: unit direction toward the viewer
    Vec3 toward(const Vec3& point) const { return distant ? place : place - point; }
};

/// An image plane in front of a viewer.
class Screen {
  public:
    /// The camera's image, with pixel coordinates as in camera.h.
    static Screen ofCamera(const Camera& camera);
    /// A plane orthogonal to a distant light's direction; the pixel size is `pixelWorld`.
    static Screen ofDistantLight(const Vec3& toLightWorld, const Vec3& centerWorld, double pixelWorld);
    /// One of the six faces of a cube map around a light, a square of `size` pixels.
    static Screen ofCubeFace(const Vec3& lightWorld, int face, int size);

    const Viewpoint& viewpoint() const { return viewpoint_; }
    /// x and y in pixels, and the depth. x and y are meaningless behind a perspective viewer.
    Vec3 project(const Vec3& pointWorld) const;
    bool inFront(const Vec3& projected) const { return !perspective_ || projected.z > 0; }
    /// Homogeneous pixel coordinates (xw, yw, w), linear in world space; w is negative behind a perspective
    /// viewer.
    Vec3 projectHomogeneous(const Vec3& pointWorld) const;
    /// Maximum number of pixels per world unit, orthogonal to the line of sight, at a point.
    double pixelsPerWorld(const Vec3& projected) const;
    /// The world point at a pixel and a depth.
    Vec3 unproject(const Vec3& projected) const;

  private:
    Viewpoint viewpoint_;
    bool perspective_ = true;
    Vec3 origin_{0}, right_{1, 0, 0}, down_{0, 1, 0}, forward_{0, 0, 1};
    double scale_ = 1; // pixels per world unit; at depth 1 if perspective
    Vec2 center_{0};
};

} // namespace plumbline
