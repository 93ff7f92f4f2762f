// Silhouette: which pixels show an object, held against which pixels should.
//
// With R_k and T_k the sets of pixels that show object k in the reference and in the test,
//     IoU = sum_k |R_k n T_k| / sum_k |R_k u T_k|                    (Jaccard 1901; the sums are over the
//     selection) missing = sum_k |R_k \ T_k|        extra = sum_k |T_k \ R_k|
// A pixel that shows one object in the reference and another in the test is missing from the one and extra in
// the other. Unit: pixels. Never looks at anything but coverage.
#pragma once

#include "figure.h"
#include "frame_pair.h"

namespace plumbline {

struct SilhouetteIou {
    Figure iou;                               // in [0, 1]; absent if neither frame shows any of the objects
    uint64_t referencePx = 0, testPx = 0;     // sum |R_k|, sum |T_k|
    uint64_t intersectionPx = 0, unionPx = 0; // the two sums of the ratio
    uint64_t missingPx = 0, extraPx = 0;
};

SilhouetteIou computeSilhouetteIou(const FramePair& pair, ObjectSelection selection);

/// Under the keys of results.json.
MetricValues valuesOf(const SilhouetteIou& result);

} // namespace plumbline
