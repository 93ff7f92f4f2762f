// Shadow: whether the two frames agree on where one light is blocked.
//
// Domain: pixels both frames cover with the same object of the selection, where both shadow values are
// finite. A value >= 0.5 counts as shadow (this project's frames hold 0 and 1; another renderer's penumbra is
// cut at its middle). With TP, TN, FP, FN the pixels in shadow in both, lit in both, in shadow in the test
// alone, lit in the test alone:
//     agreement = (TP + TN) / domain      IoU = TP / (TP + FP + FN)      F1 = 2 TP / (2 TP + FP + FN)
//     BER = (FP / (TN + FP) + FN / (TP + FN)) / 2                        (balanced error rate)
// Both cast and attached shadows count (apart: shadow_kinds.h). Never looks at depth: a pixel may be in the
// right shadow for a wrong reason.
//
// Intervals: [low, high] of agreement, IoU and F1 are their ranges over all true images that the reference
// leaves open, pixel by pixel, independently:
//     `uncertain`           the true image may show any object or none: a pixel may leave the domain; one
//     that the test covers
//                           with an object of the selection may enter it, and is lit or dark there
//     `uncertain.shadow.L`  what the reference sees there may be lit or dark
// A pixel with neither is as the reference says; a pixel with `uncertain` alone that stays keeps its shadow.
// What a pixel adds is a hit, a miss or nothing, so that interval.h has the closed form. BER has none: its
// two rates pull against each other.
#pragma once

#include "validate/metrics/metric.h"

#include <cmath>
#include <string>

namespace plumbline {

/// Calls visit(pixel, dark in the reference, dark in the test) for every pixel of the domain. Both frames
/// must have the light's channel. Returns the number of shared pixels without a finite value in both.
template <class Visit>
uint64_t forShadowPixels(const FramePair& pair, ObjectSelection selection, const std::string& light,
                         Visit&& visit) {
    const auto reference = pair.reference().channel(shadowChannel(light)),
               test = pair.test().channel(shadowChannel(light));
    uint64_t invalidPx = 0;
    forSharedPixels(pair, selection, [&](uint32_t pixel, const ObjectInfo&) {
        if (std::isfinite(reference[pixel]) && std::isfinite(test[pixel]))
            visit(pixel, isShadow(reference[pixel]), isShadow(test[pixel]));
        else
            ++invalidPx;
    });
    return invalidPx;
}

struct ShadowAgreement {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0;                     // shared, but a shadow value is NaN or infinite
    uint64_t bothShadowPx = 0, bothLitPx = 0;   // TP, TN
    uint64_t falseShadowPx = 0, falseLitPx = 0; // FP, FN
    Figure agreement, iou, f1;                  // in [0, 1], 1 = equal
    Figure ber; // in [0, 1], 0 = equal; absent if the reference is all lit or all dark
    Interval agreementRange, iouRange,
        f1Range;        // absent without both channels, and where the figure is absent
    Figure uncertainPx; // pixels the test covers with the selection, whose shadow or part in the domain is
                        // uncertain
};

/// `light`: name as in "shadow.<light>". All figures are absent if a frame lacks the channel.
ShadowAgreement computeShadowAgreement(const FramePair& pair, ObjectSelection selection,
                                       const std::string& light);

Metric shadowAgreementMetric();

} // namespace plumbline
