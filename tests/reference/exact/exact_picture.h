// The picture of a scene that holds one flat relief, exact at any place of a pixel; and a frame compared with
// it.
#pragma once

#include "scenes/frame/frame.h"
#include "tests/reference/exact/exact_plane_tracer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace plumbline {

class ExactPicture {
  public:
    /// Places are in pixels, centers at + 0.5. The scene must outlive the picture.
    explicit ExactPicture(const Scene& scene);

    /// Planar depth of what a place shows; infinite on a miss.
    double depthAt(const Vec2& place) const;
    /// Whether each light is blocked from what a place shows; empty on a miss.
    std::vector<bool> shadowsAt(const Vec2& place) const;

    // Diagnostics: what an error of so many pixels could change. They look along 16 directions, at the radius
    // and at half of it.

    bool coverageCouldFlip(const Vec2& place, double radiusPx) const;
    bool shadowCouldFlip(const Vec2& place, size_t light, double radiusPx) const;
    /// Whether the depth jumps within the radius: is discontinuous, not merely steep; and by enough for
    /// `depth` to come from the jump's other side.
    bool depthCouldJumpTo(const Vec2& place, double radiusPx, double depth) const;

  private:
    bool depthJumpsBetween(Vec2 a, Vec2 b, double atLeast) const;

    const Scene& scene_;
    CameraRays rays_;
    ExactPlaneTracer tracer_;
};

/// How a frame differs from the exact picture. Pixels the frame calls uncertain are counted and left out of
/// the rest; a frame without those channels is certain everywhere.
struct Comparison {
    int pixels = 0, covered = 0, uncertain = 0;
    int coverageWrong = 0;
    int depthCompared = 0, depthWrong = 0;
    int depthJumped = 0;   // off, but the exact depth jumps within the radius allowed
    double worstDepth = 0; // relative; of those neither wrong nor jumped
    int shadowCompared = 0, shadowUncertain = 0, shadowWrong = 0; // all lights
    /// Radius in pixels, a power of two, within which the exact picture shows what the frame shows at every
    /// pixel whose coverage or shadow is wrong, or whose depth jumped (of the first 500); infinite if 8
    /// pixels don't suffice. How wide a band the frame would have had to call uncertain.
    double coverageBandPx = 0, depthBandPx = 0, shadowBandPx = 0;
    std::vector<std::string> firstWrong; // a line each
    double uncertainShare() const { return double(uncertain) / pixels; }
    double shadowUncertainShare() const {
        return double(shadowUncertain) / std::max(1, shadowCompared + shadowUncertain);
    }
    std::string summary() const;
};

/// Relative error of depth that is none: the reference's vertices and depths are float, good to 6e-8 of a
/// world unit or two, and a refined hit is as good as the ray's crossing of the surface allows.
inline constexpr double kSameDepth = 1e-5;

/// `jumpRadiusPx`: how far the frame may be off sideways where one part of the surface hides another.
Comparison compareWithExact(const Scene& scene, const Frame& frame, double jumpRadiusPx);

} // namespace plumbline
