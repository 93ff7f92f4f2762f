#include "validate/metrics/contour_distance.h"

#include "scenes/core/nearest_rank.h"
#include "validate/metrics/distance_transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline {
namespace {

using Contour = std::vector<Pixel>;

/// The contour of one frame's mask. `ids`: of that frame.
Contour findContour(const FramePair& pair, ObjectSelection selection, std::span<const int> ids) {
    int largestId = 0;
    for (const ObjectInfo& object : pair.objects())
        largestId = std::max(largestId, object.id);
    std::vector<bool> selected(static_cast<size_t>(largestId) + 1);
    for (const size_t index : selection)
        selected[static_cast<size_t>(pair.objects()[index].id)] = true;

    const int width = pair.reference().width(), height = pair.reference().height();
    const auto outside = [&](size_t pixel) { return !selected[static_cast<size_t>(ids[pixel])]; };
    Contour contour;
    for (const size_t index : selection)
        for (const uint32_t pixel : pair.pixelsOf(index)) {
            if (ids[pixel] != pair.objects()[index].id) continue; // only the other frame shows it
            const auto stride = static_cast<uint32_t>(width);
            const int x = static_cast<int>(pixel % stride), y = static_cast<int>(pixel / stride);
            if ((x > 0 && outside(pixel - 1)) || (x + 1 < width && outside(pixel + 1)) ||
                (y > 0 && outside(pixel - stride)) || (y + 1 < height && outside(pixel + stride)))
                contour.push_back({x, y});
        }
    return contour;
}

/// Distances in pixels from each pixel of one contour to the other.
std::vector<double> distancesBetween(const Contour& from, const Contour& to, const PixelBox& box) {
    const std::vector<int64_t> squared = DistanceTransform(to, box).squaredDistancesOf(from);
    std::vector<double> distances(squared.size());
    std::transform(squared.begin(), squared.end(), distances.begin(),
                   [](int64_t value) { return std::sqrt(static_cast<double>(value)); });
    return distances;
}

/// Empty if both frames have a contour.
std::string noContourReason(const ContourDistance& result) {
    if (result.referencePx > 0 && result.testPx > 0) return {};
    return fmt::format("{} no contour of it, because it covers no pixel or all of them",
                       result.testPx > 0        ? "the reference frame shows"
                       : result.referencePx > 0 ? "the test frame shows"
                                                : "neither frame shows");
}

} // namespace

ContourDistance computeContourDistance(const FramePair& pair, ObjectSelection selection) {
    const Contour inReference = findContour(pair, selection, pair.referenceIds());
    const Contour inTest = findContour(pair, selection, pair.testIds());
    ContourDistance result;
    result.referencePx = inReference.size();
    result.testPx = inTest.size();
    if (const std::string reason = noContourReason(result); !reason.empty()) {
        result.meanPx = result.hausdorff95Px = Figure::absent(reason);
        return result;
    }
    PixelBox box;
    box.include(inReference);
    box.include(inTest);
    const std::vector<double> there = distancesBetween(inReference, inTest, box);
    const std::vector<double> back = distancesBetween(inTest, inReference, box);
    const double sum =
        std::accumulate(there.begin(), there.end(), 0.0) + std::accumulate(back.begin(), back.end(), 0.0);
    result.meanPx = sum / static_cast<double>(there.size() + back.size());
    result.hausdorff95Px = std::max(nearestRank(there, 95), nearestRank(back, 95));
    return result;
}

Metric contourDistanceMetric() {
    return makeMetric<ContourDistance>({
        .group = "silhouette",
        .domain = "contours A of R, B of T: pixels with a 4-neighbor in the image outside the silhouette",
        .rows = {{{.key = "contour_mean_px",
                   .label = "contour distance, mean",
                   .unit = Unit::Pixels,
                   .goal = Goal::Zero,
                   .meaning = "mean distance of the pixels of each contour to the other contour",
                   .formula = "(Σ_a d(a,B) + Σ_b d(b,A)) / (|A| + |B|)",
                   .source = "Heimann et al. 2009, IEEE TMI 28(8)",
                   .report = {{"contour distance", "mean, px", "{:.2f}"}}},
                  &ContourDistance::meanPx},
                 {{.key = "hausdorff95_px",
                   .label = "contour distance, p95",
                   .unit = Unit::Pixels,
                   .goal = Goal::Zero,
                   .meaning =
                       "larger of the two 95th percentiles of the distance from one contour to the other",
                   .formula = "max(p95_a d(a,B), p95_b d(b,A))",
                   .source = "Huttenlocher et al. 1993, IEEE PAMI 15(9); Taha, Hanbury 2015",
                   .report = {{"contour distance", "p95, px", "{:.2f}"}}},
                  &ContourDistance::hausdorff95Px},
                 {{.key = "contour_reference_px",
                   .label = "contour of the reference",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels of the contour in the reference",
                   .formula = "|A|"},
                  &ContourDistance::referencePx},
                 {{.key = "contour_test_px",
                   .label = "contour of the test",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels of the contour in the test",
                   .formula = "|B|"},
                  &ContourDistance::testPx}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeContourDistance(input.pair, selection); },
    });
}

} // namespace plumbline
