// Ground truth for scenes with one flat relief, exact at any point of a pixel, and the comparison of a frame
// with it.
#pragma once

#include "scenes/frame/frame.h"
#include "tests/reference/exact/exact_plane_tracer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace plumbline {

class ExactPicture {
  public:
    /// Points are in pixels, with centers at + 0.5. The scene must outlive the picture.
    explicit ExactPicture(const Scene& scene);

    /// Planar depth at a point; infinite on a miss.
    double depthAt(const Vec2& place) const;
    /// Whether each light is occluded at a point; empty on a miss.
    std::vector<bool> shadowsAt(const Vec2& place) const;

    // Diagnostics of what an error of a given number of pixels could change. They sample 16 directions, at
    // the radius and at half of it.

    bool coverageCouldFlip(const Vec2& place, double radiusPx) const;
    bool shadowCouldFlip(const Vec2& place, size_t light, double radiusPx) const;
    /// Whether the depth is discontinuous within the radius, not merely steep, by enough for `depth` to be on
    /// the other side of the discontinuity.
    bool depthCouldJumpTo(const Vec2& place, double radiusPx, double depth) const;

  private:
    bool depthJumpsBetween(Vec2 a, Vec2 b, double atLeast) const;

    const Scene& scene_;
    CameraRays rays_;
    ExactPlaneTracer tracer_;
};

/// Differences between a frame and the exact picture. Pixels that the frame marks as uncertain are counted
/// and excluded from the rest; a frame without these channels is certain everywhere.
struct Comparison {
    int pixels = 0, covered = 0, uncertain = 0;
    int coverageWrong = 0;
    int depthCompared = 0, depthWrong = 0;
    int depthJumped = 0;   // wrong, but the exact depth is discontinuous within the allowed radius
    double worstDepth = 0; // relative; of the other pixels
    int shadowCompared = 0, shadowUncertain = 0, shadowWrong = 0; // all lights
    /// Radius in pixels, a power of two, within which the exact picture contains the frame's value, for every
    /// pixel whose coverage or shadow is wrong or whose depth jumped (of the first 500); infinite if 8 pixels
    /// aren't sufficient. It is the width of the band that the frame should have marked as uncertain.
    double coverageBandPx = 0, depthBandPx = 0, shadowBandPx = 0;
    std::vector<std::string> firstWrong; // one line each
    double uncertainShare() const { return double(uncertain) / pixels; }
    double shadowUncertainShare() const {
        return double(shadowUncertain) / std::max(1, shadowCompared + shadowUncertain);
    }
    std::string summary() const;
};

/// Relative error of depth that counts as rounding: the reference's vertices and depths are floats, accurate
/// to 6e-8 of one or two world units, and the accuracy of a refined hit depends on the angle between ray and
/// surface.
inline constexpr double kSameDepth = 1e-5;

/// `jumpRadiusPx`: allowed lateral error of the frame where one part of the surface occludes another.
Comparison compareWithExact(const Scene& scene, const Frame& frame, double jumpRadiusPx);

} // namespace plumbline
