// Boundary IoU: the IoU of the rims (boundary regions) of two silhouettes (Cheng, Girshick, Dollar, Berg and
// Kirillov 2021, "Boundary IoU: improving object-centric image segmentation evaluation", CVPR, Eq. 4). The
// IoU of large objects is insensitive to errors of their outline; this metric measures the outline alone.
//
// R is the set of pixels that show an object in the reference, R_d the subset within the distance d of its
// outline; T and T_d are those of the test:
//     boundary IoU = sum_k |R_d n T_d| / sum_k |R_d u T_d|, k the objects of the selection
// R_d: the pixels of R for which some pixel of the image outside R has its center at most d away (Euclidean).
// R_1 is therefore the contour of contour_distance.h. The code of the paper erodes by squares, which is the
// distance max(|dx|, |dy|), so its rims are thinner by 0.7 along diagonals; the Euclidean distance doesn't
// change when an image is rotated. The code of the paper also counts the image border as outline. No metric
// of outlines here does, because what lies beyond the border isn't known.
//
// d = 1, 2 and 4 px, and 2 % of the image diagonal (the paper's choice) but at least 1 px. Only coverage is
// used. Symmetric. At large d the rim of a thin object is the whole object, and boundary IoU equals IoU.
//
// Interval. At an uncertain pixel (channel `uncertain` of the reference) the true image may show any object
// or none. What it shows there moves the rims around it, so pixels aren't independent and the exact range
// would need a search. Instead, [low, high] encloses that range. With U the uncertain pixels, every true mask
// R' contains R \ U and lies in R u U. Two sets therefore bound its rim, certain rim <= R'_d <= possible rim:
//     certain rim    pixels of R \ U with a pixel outside R and U at most d away
//     possible rim   pixels of R u U with a pixel outside R, or in U, at most d away (itself, if uncertain)
// Outside U, a pixel of the certain rim has one outcome; one of the possible rim alone is a hit or a miss if
// it is in T_d, a miss or nothing otherwise. A pixel of U in a T_d is a hit, a miss or, if the true image may
// show another object of the selection, two misses; in no T_d it is a miss or nothing. interval.h has the
// closed form. The IoU of every true image lies in the interval; its ends may not be attained.
#pragma once

#include "validate/metrics/metric.h"

#include <array>

namespace plumbline {

/// Distances d, in the order of the arrays below, by their names in results.
inline constexpr std::array<const char*, 4> kBoundaryWidths{"1px", "2px", "4px", "2pct"};

struct BoundaryIou {
    struct AtWidth {
        Figure iou;     // in [0, 1]; absent if neither frame shows an outline
        Interval range; // absent without the channel `uncertain`, and where iou is absent
        uint64_t intersectionPx = 0, unionPx = 0;
    };
    std::array<AtWidth, kBoundaryWidths.size()> at;
};

/// Rims of one object in both frames, for every width.
struct BoundaryRims {
    struct AtWidth {
        uint64_t intersectionPx = 0, unionPx = 0;
        RatioRange certain;           // over the pixels that aren't uncertain
        uint64_t uncertainTestPx = 0; // uncertain pixels in the test's rim
    };
    std::array<AtWidth, kBoundaryWidths.size()> at;
};

/// One for each of the pair's objects, in their order.
std::vector<BoundaryRims> findBoundaryRims(const FramePair& pair);

/// `rims`: from findBoundaryRims.
BoundaryIou computeBoundaryIou(const FramePair& pair, ObjectSelection selection,
                               std::span<const BoundaryRims> rims);

Metric boundaryIouMetric();

} // namespace plumbline
