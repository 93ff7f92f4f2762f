// Normals: the angle between the two frames' surface normals.
//
// Domain: pixels both frames cover with the same object of the selection, where both normals (N.X N.Y N.Z)
// are finite and not zero; they needn't be unit. Angle = atan2(|a x b|, a . b), which keeps its precision
// near 0 and 180 degrees where acos loses it (Kahan, "How futile are mindless assessments of roundoff",
// section 12). Unit: degrees, in [0, 180].
#pragma once

#include "figure.h"
#include "frame_pair.h"

namespace plumbline {

struct NormalAngle {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0; // shared, but a normal is zero, NaN or infinite
    Figure meanDegrees, p95Degrees;
};

NormalAngle computeNormalAngle(const FramePair& pair, ObjectSelection selection);

/// Under the keys of results.json.
MetricValues valuesOf(const NormalAngle& result);

} // namespace plumbline
