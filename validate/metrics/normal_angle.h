// Normal error: the angle between the surface normals of the two frames.
//
// Domain: pixels that both frames cover with the same object of the selection, where both normals (N.X N.Y
// N.Z) are finite and nonzero; they needn't be normalized. Angle = atan2(|a x b|, a . b), which is precise
// near 0 and 180 degrees, where acos isn't (Kahan, "How futile are mindless assessments of roundoff",
// section 12). Unit: degrees, in [0, 180].
#pragma once

#include "validate/metrics/metric.h"

#include <array>

namespace plumbline {

struct NormalAngle {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0; // shared, but a normal is zero, NaN or infinite
    Figure meanDegrees, p95Degrees;
};

/// The angle per pixel, regardless of the objects shown there. The pair must outlive it.
class PixelNormalAngle {
  public:
    explicit PixelNormalAngle(const FramePair& pair);
    /// Why there are no angles (a channel that a frame lacks); empty if there are.
    const std::string& missing() const { return missing_; }
    /// Degrees in [0, 180]; NaN where either frame has no usable normal. Requires that missing() is empty.
    double degreesAt(uint32_t pixel) const;

  private:
    std::string missing_;
    std::array<std::span<const float>, 3> reference_, test_;
};

NormalAngle computeNormalAngle(const FramePair& pair, ObjectSelection selection);

Metric normalAngleMetric();

} // namespace plumbline
