// Contour distance: the distance between the outlines of two silhouettes, in pixels.
//
// The mask of a frame is the set of pixels that show an object of the selection. For several objects it is
// their union, so lines between them are no contour. Its contour is the pixels of the mask that have a
// 4-neighbor inside the image and outside the mask. The image border is no contour, because what lies beyond
// it isn't known. The edge of an object outside the selection that occludes the mask is a contour.
//
// A and B are the contours of reference and test, d(a, B) is the Euclidean distance from the center of a to
// the nearest pixel center of B:
//     mean = (sum_a d(a, B) + sum_b d(b, A)) / (|A| + |B|)
//         average symmetric surface distance (Heimann et al. 2009, "Comparison and evaluation of methods for
//         liver segmentation from CT datasets", IEEE TMI 28(8)), applied to contours
//     HD95 = max(p95_a d(a, B), p95_b d(b, A)), each by nearest rank
//         Hausdorff distance with the 95th percentile in place of the largest (Huttenlocher et al. 1993,
//         "Comparing images using the Hausdorff distance", IEEE PAMI 15(9); Taha and Hanbury 2015, "Metrics
//         for evaluating 3D medical image segmentation", BMC Medical Imaging 15:29), applied to contours
// Both are symmetric. Unit: pixels. Distances are exact except for the rounding of square roots and sums.
//
// There is no interval: the channel `uncertain` isn't used. Uncertain pixels lie mostly along the outline,
// where each may move it by about a pixel. Means far below a pixel are significant only if the reference has
// few uncertain pixels there.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct ContourDistance {
    Figure meanPx, hausdorff95Px;         // absent if either frame has no contour
    uint64_t referencePx = 0, testPx = 0; // |A|, |B|
};

ContourDistance computeContourDistance(const FramePair& pair, ObjectSelection selection);

Metric contourDistanceMetric();

} // namespace plumbline
