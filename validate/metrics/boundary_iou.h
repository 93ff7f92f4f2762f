// Boundary IoU: the overlap of the rims of two silhouettes (Cheng, Girshick, Dollar, Berg and Kirillov 2021,
// "Boundary IoU: improving object-centric image segmentation evaluation", CVPR, Eq. 4). IoU of large objects
// hardly sees their outline; this sees nothing else.
//
// With R the pixels that show an object in the reference and R_d those of them within the distance d of its
// outline, T and T_d likewise of the test:
//     boundary IoU = sum_k |R_d n T_d| / sum_k |R_d u T_d|, k the objects of the selection
// R_d: the pixels of R with a pixel of the picture outside R whose center is at most d away, Euclidean. So
// R_1 is the contour of contour_distance.h. The paper's code erodes by squares, which is the distance
// max(|dx|, |dy|): a rim thinner by 0.7 along diagonals; the distance meant is the one that turning a picture
// leaves as it is. It also takes the picture's border for outline; here it isn't, as for every figure of
// outlines: what is beyond isn't known.
//
// d = 1, 2 and 4 px, and 2 % of the picture's diagonal (the paper's choice) but at least 1 px. Never looks at
// anything but coverage. Symmetric. The rim of a thin object is all of it, at large d: then this is IoU.
//
// Interval. At an uncertain pixel (channel `uncertain` of the reference) the true image may show any object
// or none, and what it shows there moves the rims around it, so that pixels aren't independent and the exact
// range would take a search. Instead [low, high] encloses it. With U the uncertain pixels, every true mask R'
// has R \ U in it and nothing outside R u U, so
//     surely rim     pixels of R \ U with one of neither R nor U at most d away
//     possibly rim   pixels of R u U with one outside R, or of U, at most d away (itself, if it is uncertain)
// hold whatever is true: surely <= R'_d <= possibly. Outside U, a pixel surely rim adds what it adds; one
// possibly rim adds a hit or a miss where it is in T_d, a miss or nothing elsewhere. A pixel of U in a T_d
// adds a hit, a miss or, where the truth may be another object of the selection, two misses; elsewhere a miss
// or nothing. interval.h has the closed form. True IoUs never lie outside; the ends may not be reached.
#pragma once

#include "validate/metrics/metric.h"

#include <array>

namespace plumbline {

/// Distances d, in the order of the arrays below, by their names in results.
inline constexpr std::array<const char*, 4> kBoundaryWidths{"1px", "2px", "4px", "2pct"};

struct BoundaryIou {
    struct AtWidth {
        Figure iou;     // in [0, 1]; absent if neither frame shows an outline
        Interval range; // encloses; absent without the channel `uncertain`, and where iou is absent
        uint64_t intersectionPx = 0, unionPx = 0;
    };
    std::array<AtWidth, kBoundaryWidths.size()> at;
};

/// Rims of one object in both frames, for every width.
struct BoundaryRims {
    struct AtWidth {
        uint64_t intersectionPx = 0, unionPx = 0;
        RatioRange certain;           // of the pixels that aren't uncertain
        uint64_t uncertainTestPx = 0; // uncertain ones in the test's rim
    };
    std::array<AtWidth, kBoundaryWidths.size()> at;
};

/// Of each of the pair's objects, in their order.
std::vector<BoundaryRims> findBoundaryRims(const FramePair& pair);

/// `rims`: of findBoundaryRims.
BoundaryIou computeBoundaryIou(const FramePair& pair, ObjectSelection selection,
                               std::span<const BoundaryRims> rims);

Metric boundaryIouMetric();

} // namespace plumbline
