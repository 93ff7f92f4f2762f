// Shadow agreement: whether the two frames agree on the pixels at which one light is blocked.
//
// Domain: pixels that both frames cover with the same object of the selection, where both shadow values are
// finite. A value >= 0.5 counts as shadow (frames of this project contain 0 and 1; penumbrae of other
// renderers are cut at their middle). With TP, TN, FP, FN the pixels in shadow in both, lit in both, in
// shadow in the test only, lit in the test only:
//     agreement = (TP + TN) / domain      IoU = TP / (TP + FP + FN)      F1 = 2 TP / (2 TP + FP + FN)
//     BER = (FP / (TN + FP) + FN / (TP + FN)) / 2                        (balanced error rate)
// Both cast and attached shadows count (shadow_kinds.h separates them). Depth isn't used: a pixel may be in
// shadow in both frames because of different occluders.
//
// Intervals: [low, high] of agreement, IoU and F1 are their ranges over all true images that the reference's
// channels allow, independently at each pixel:
//     `uncertain`           the true image may show any object or none: a pixel may leave the domain; one
//                           that the test covers with an object of the selection may enter it, lit or dark
//     `uncertain.shadow.L`  the point that the reference shows may be lit or dark
// A pixel marked in neither is as in the reference. A pixel marked in `uncertain` alone keeps its shadow
// value if it stays in the domain. A pixel contributes a hit, a miss or nothing, so interval.h has the closed
// form. BER has no interval: a pixel's outcome changes both of its rates, so the extremes can't be found
// pixel by pixel.
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
    Figure ber; // in [0, 1], 0 = equal; absent if the reference is lit or dark at all pixels of the domain
    Interval agreementRange, iouRange,
        f1Range; // absent without both channels, and where the figure is absent
    /// Pixels that the test covers with the selection and whose shadow or membership in the domain is
    /// uncertain.
    Figure uncertainPx;
};

/// `light`: name as in "shadow.<light>". All figures are absent if a frame lacks the channel.
ShadowAgreement computeShadowAgreement(const FramePair& pair, ObjectSelection selection,
                                       const std::string& light);

Metric shadowAgreementMetric();

} // namespace plumbline
