// Outlines: how far apart, in pixels, the outlines of two silhouettes run.
//
// The mask of a frame is the pixels that show an object of the selection: of several objects their union, so
// that lines between them are no outline. Its contour is the pixels of the mask with a 4-neighbor inside the
// picture that is outside the mask; along the picture's border a mask has none, for what is beyond isn't
// known. Where an object outside the selection stands in front, its edge is a contour too.
//
// With A and B the contours of reference and test, d(a, B) the Euclidean distance of the center of a to the
// nearest of B:
//     mean = (sum_a d(a, B) + sum_b d(b, A)) / (|A| + |B|)
//         average symmetric surface distance (Heimann et al. 2009, "Comparison and evaluation of methods for
//         liver segmentation from CT datasets", IEEE TMI 28(8)), of contours
//     HD95 = max(p95_a d(a, B), p95_b d(b, A)), each by nearest rank
//         Hausdorff distance with the 95th percentile in place of the largest (Huttenlocher et al. 1993,
//         "Comparing images using the Hausdorff distance", IEEE PAMI 15(9); Taha and Hanbury 2015, "Metrics
//         for evaluating 3D medical image segmentation", BMC Medical Imaging 15:29), of contours
// Both are symmetric. Unit: pixels. Distances are exact, but for the rounding of their roots and sums.
//
// There is no interval: the channel `uncertain` isn't looked at. Uncertain pixels lie mostly along the
// outline, where each may move it by about a pixel: means far below that are no finding unless the reference
// is sure of its outline.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct ContourDistance {
    Figure meanPx, hausdorff95Px;         // absent if either frame shows no contour
    uint64_t referencePx = 0, testPx = 0; // |A|, |B|
};

ContourDistance computeContourDistance(const FramePair& pair, ObjectSelection selection);

Metric contourDistanceMetric();

} // namespace plumbline
