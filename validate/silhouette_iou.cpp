#include "silhouette_iou.h"

namespace plumbline {

SilhouetteIou computeSilhouetteIou(const FramePair& pair, ObjectSelection selection) {
    SilhouetteIou result;
    for (const size_t index : selection) {
        const int id = pair.objects()[index].id;
        for (const uint32_t pixel : pair.pixelsOf(index)) {
            const bool inReference = pair.referenceIds()[pixel] == id, inTest = pair.testIds()[pixel] == id;
            result.referencePx += inReference;
            result.testPx += inTest;
            result.intersectionPx += inReference && inTest;
            result.missingPx += inReference && !inTest;
            result.extraPx += inTest && !inReference;
        }
    }
    result.unionPx = result.intersectionPx + result.missingPx + result.extraPx;
    result.iou = Figure::ratio(result.intersectionPx, result.unionPx, "neither frame shows it");
    return result;
}

MetricValues valuesOf(const SilhouetteIou& result) {
    return {{"iou", result.iou},          {"missing_px", result.missingPx},
            {"extra_px", result.extraPx}, {"reference_px", result.referencePx},
            {"test_px", result.testPx},   {"intersection_px", result.intersectionPx},
            {"union_px", result.unionPx}};
}

} // namespace plumbline
