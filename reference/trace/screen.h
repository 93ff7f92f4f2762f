// What a camera or a light has before it: a plane in units of its own ("pixels") that world points are
// projected onto. World space, world units.
#pragma once

#include "scenes/core/math.h"
#include "scenes/scene/camera.h"

namespace plumbline {

/// Where a surface is looked at from.
struct Viewpoint {
    bool distant = false;
    Vec3 place{0}; // world; if distant: unit direction toward the viewer
    Vec3 toward(const Vec3& point) const { return distant ? place : place - point; }
};

/// A plane in front of a viewer, in units of its own ("pixels").
class Screen {
  public:
    /// The picture: pixel coordinates as in camera.h.
    static Screen ofCamera(const Camera& camera);
    /// Across a distant light's direction; one pixel is `pixelWorld`.
    static Screen ofDistantLight(const Vec3& toLightWorld, const Vec3& centerWorld, double pixelWorld);
    /// One of the six faces of a cube around a light, each a square of `size` pixels.
    static Screen ofCubeFace(const Vec3& lightWorld, int face, int size);

    const Viewpoint& viewpoint() const { return viewpoint_; }
    /// x, y in pixels and depth away from the viewer. Behind a near viewer x and y mean nothing.
    Vec3 project(const Vec3& pointWorld) const;
    bool inFront(const Vec3& projected) const { return !perspective_ || projected.z > 0; }
    /// Pixels a world unit across the line of sight has at a place, at most.
    double pixelsPerWorld(const Vec3& projected) const;
    /// The world point at a pixel and a depth.
    Vec3 unproject(const Vec3& projected) const;

  private:
    Viewpoint viewpoint_;
    bool perspective_ = true;
    Vec3 origin_{0}, right_{1, 0, 0}, down_{0, 1, 0}, forward_{0, 0, 1};
    double scale_ = 1; // pixels per world unit, at depth 1 if perspective
    Vec2 center_{0};
};

} // namespace plumbline
