// Shadow: whether the two frames agree on where one light is blocked.
//
// Domain: pixels both frames cover with the same object of the selection, where both shadow values are
// finite. A value
// >= 0.5 counts as shadow (this project's frames hold 0 and 1; another renderer's penumbra is cut at its
// middle). With TP, TN, FP, FN the pixels in shadow in both, lit in both, in shadow in the test alone, lit in
// the test alone:
//     agreement = (TP + TN) / domain      IoU = TP / (TP + FP + FN)      F1 = 2 TP / (2 TP + FP + FN)
//     BER = (FP / (TN + FP) + FN / (TP + FN)) / 2                        (balanced error rate)
// Both cast and attached shadows count. Never looks at depth: a pixel may be in the right shadow for a wrong
// reason.
#pragma once

#include "figure.h"
#include "frame_pair.h"

#include <string>

namespace plumbline {

struct ShadowAgreement {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0;                     // shared, but a shadow value is NaN or infinite
    uint64_t bothShadowPx = 0, bothLitPx = 0;   // TP, TN
    uint64_t falseShadowPx = 0, falseLitPx = 0; // FP, FN
    Figure agreement, iou, f1;                  // in [0, 1], 1 = equal
    Figure ber; // in [0, 1], 0 = equal; absent if the reference is all lit or all dark
};

/// `light`: name as in "shadow.<light>". All figures are absent if a frame lacks the channel.
ShadowAgreement computeShadowAgreement(const FramePair& pair, ObjectSelection selection,
                                       const std::string& light);

/// Under the keys of results.json.
MetricValues valuesOf(const ShadowAgreement& result);

} // namespace plumbline
