// Silhouette IoU: the overlap of the pixels that show an object in the two frames.
//
// R_k and T_k are the sets of pixels that show object k in the reference and in the test; sums are over the
// selection:
//     IoU = sum_k |R_k n T_k| / sum_k |R_k u T_k|        (Jaccard 1901)
//     missing = sum_k |R_k \ T_k|        extra = sum_k |T_k \ R_k|
// A pixel that shows one object in the reference and another in the test is missing from the one and extra in
// the other. Unit: pixels. Only coverage is used.
//
// Interval: at an uncertain pixel (channel `uncertain` of the reference) the true image may show any object
// of the scene or none, independently of the other pixels; [low, high] is the range of IoU over all such true
// images. Outcomes of such a pixel:
//     the test shows object k of the selection:  a hit if the true image shows k; a miss if it shows no
//                                                object of the selection; two misses if it shows another one
//                                                (missing there, extra in k)
//     the test shows none of the selection:      nothing, or a miss
// Back sides: pixels at which the reference sees the back of the surface (its channel `facing` is below 0)
// are in all sums above, and counted apart as well. A technique that culls back faces lacks them.
//
// interval.h has the closed form and its proof. Channels `uncertain` of the test frame are ignored.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct SilhouetteIou {
    Figure iou;                               // in [0, 1]; absent if neither frame shows any of the objects
    uint64_t referencePx = 0, testPx = 0;     // sum |R_k|, sum |T_k|
    uint64_t intersectionPx = 0, unionPx = 0; // the two sums of the ratio
    uint64_t missingPx = 0, extraPx = 0;
    Figure backPx, missingBackPx; // of sum |R_k| and of missing; absent without the channel `facing`
    Interval iouRange;            // absent without the channel `uncertain`, and where iou is absent
    Figure uncertainPx;           // uncertain pixels of the whole frame
};

SilhouetteIou computeSilhouetteIou(const FramePair& pair, ObjectSelection selection);

Metric silhouetteIouMetric();

} // namespace plumbline
