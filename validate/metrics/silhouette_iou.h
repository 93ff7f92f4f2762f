// Silhouette: which pixels show an object, held against which pixels should.
//
// With R_k and T_k the sets of pixels that show object k in the reference and in the test, sums over the
// selection:
//     IoU = sum_k |R_k n T_k| / sum_k |R_k u T_k|        (Jaccard 1901)
//     missing = sum_k |R_k \ T_k|        extra = sum_k |T_k \ R_k|
// A pixel that shows one object in the reference and another in the test is missing from the one and extra in
// the other. Unit: pixels. Never looks at anything but coverage.
//
// Interval: at an uncertain pixel (channel `uncertain` of the reference) the true image may show any object
// of the scene or none, independently of the other pixels; [low, high] is the range of IoU over all such true
// images. What the pixel adds:
//     the test shows an object k of the selection:  a hit if that is true; a miss if the truth is none of the
//     selection;
//         two misses if it is another object of the selection (missing there, extra in k)
//     the test shows none of the selection:         nothing, or a miss
// interval.h has the closed form and its proof. Channels `uncertain` of the test frame are never looked at.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct SilhouetteIou {
    Figure iou;                               // in [0, 1]; absent if neither frame shows any of the objects
    uint64_t referencePx = 0, testPx = 0;     // sum |R_k|, sum |T_k|
    uint64_t intersectionPx = 0, unionPx = 0; // the two sums of the ratio
    uint64_t missingPx = 0, extraPx = 0;
    Interval iouRange;  // absent without the channel `uncertain`, and where iou is absent
    Figure uncertainPx; // uncertain pixels of the whole frame: each may show any object
};

SilhouetteIou computeSilhouetteIou(const FramePair& pair, ObjectSelection selection);

Metric silhouetteIouMetric();

} // namespace plumbline
