// Contour edges on a screen: which of the screen's points lie within an edge's error of it.
#pragma once

#include "reference/certify/contours.h"
#include "scenes/scene/camera.h"
#include "scenes/scene/light.h"

#include <optional>
#include <vector>

namespace plumbline {

/// A plane in front of a viewer, in units of its own ("pixels").
class Screen {
  public:
    /// The picture: pixel coordinates as in camera.h.
    static Screen ofCamera(const Camera& camera);
    /// Across a distant light's direction; one pixel is `pixelWorld`.
    static Screen ofDistantLight(const Vec3& toLightWorld, const Vec3& centreWorld, double pixelWorld);
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
    Vec2 centre_{0};
};

/// A short straight piece of a contour edge, on a screen.
struct EdgePiece {
    Vec3 a, b;    // projected
    Vec3 third;   // projected; the side where the micro-triangle is
    double reach; // pixels: how far the true contour may be
    double errorWorld;
    Vec3 middle() const { return 0.5 * (a + b); }
    /// Nearest point of the piece, in pixels; z by interpolation.
    Vec3 nearest(const Vec2& pixel) const;
    /// Beside the middle by a little: towards the micro-triangle, and away from it.
    Vec3 justInside() const;
    Vec3 justOutside() const { return outside(0); }
    /// Farther out, by a share of the reach.
    Vec3 outside(double ofReach) const;
};

/// Pieces of an edge that are short against their reach and a pixel; none where it isn't in front of the
/// viewer. `largest`: no reach is above this.
void forEachPiece(const Screen& screen, const ContourEdge& edge, double largestReach,
                  const std::function<void(const EdgePiece&)>& visit);

} // namespace plumbline
