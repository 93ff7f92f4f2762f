// Contour edges on a screen, in short pieces that know how far their error reaches.
#pragma once

#include "reference/certify/contours.h"
#include "reference/trace/screen.h"

#include <functional>

namespace plumbline {

/// A short straight piece of a contour edge, on a screen.
struct EdgePiece {
    Vec3 a, b;    // projected
    Vec3 third;   // projected; the side where the micro-triangle is
    double reach; // pixels: how far the true contour may be
    double errorWorld;
    Vec3 middle() const { return 0.5 * (a + b); }
    /// Nearest point of the piece, in pixels; z by interpolation.
    Vec3 nearest(const Vec2& pixel) const;
    /// Beside the middle by a little: toward the micro-triangle, and away from it.
    Vec3 justInside() const;
    Vec3 justOutside() const { return outside(0); }
    /// Farther out, by a share of the reach.
    Vec3 outside(double ofReach) const;
};

/// Pieces of an edge that are short against their reach and a pixel; none where it isn't in front of the
/// viewer, or farther from the picture, which begins at (0, 0), than its reach. No reach is above the
/// picture's diagonal.
void forEachPiece(const Screen& screen, const ContourEdge& edge, const Vec2& pictureSize,
                  const std::function<void(const EdgePiece&)>& visit);

} // namespace plumbline
