#include "contour_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace plumbline {
namespace {

struct Pixel {
    int x = 0, y = 0;
};
using Contour = std::vector<Pixel>;

/// Columns [x0, x1) of rows [y0, y1).
struct Box {
    int x0 = std::numeric_limits<int>::max(), y0 = x0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    void include(const Contour& contour) {
        for (const Pixel& pixel : contour) {
            x0 = std::min(x0, pixel.x);
            y0 = std::min(y0, pixel.y);
            x1 = std::max(x1, pixel.x + 1);
            y1 = std::max(y1, pixel.y + 1);
        }
    }
};

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
            if (ids[pixel] != pair.objects()[index].id) continue; // shown by the other frame only
            const auto stride = static_cast<uint32_t>(width);
            const int x = static_cast<int>(pixel % stride), y = static_cast<int>(pixel / stride);
            if ((x > 0 && outside(pixel - 1)) || (x + 1 < width && outside(pixel + 1)) ||
                (y > 0 && outside(pixel - stride)) || (y + 1 < height && outside(pixel + stride)))
                contour.push_back({x, y});
        }
    return contour;
}

/// Distances to a contour within a box, exactly, axis by axis (Felzenszwalb and Huttenlocher 2012, "Distance transforms of
/// sampled functions", Theory of Computing 8): first along columns, then for a row the lower envelope of the parabolas
/// (x - column)^2 + (distance in that column)^2.
class DistanceField {
  public:
    /// `contour`: not empty, inside `box`.
    DistanceField(const Contour& contour, const Box& box)
        : box_(box),
          inColumn_(static_cast<size_t>(box.width()) * static_cast<size_t>(box.y1 - box.y0), kNone) {
        for (const Pixel& pixel : contour)
            row(pixel.y)[pixel.x - box_.x0] = 0;
        for (int y = box_.y0 + 1; y < box_.y1; ++y)
            spread(row(y - 1), row(y));
        for (int y = box_.y1 - 1; y > box_.y0; --y)
            spread(row(y), row(y - 1));
    }

    /// Distance of every pixel of `from`, in their order; they lie inside the box. Fast where pixels of one row follow
    /// each other.
    std::vector<double> distancesOf(const Contour& from) {
        std::vector<double> distances;
        distances.reserve(from.size());
        int enveloped = box_.y0 - 1;
        for (const Pixel& pixel : from) {
            if (pixel.y != enveloped) buildEnvelope(row(pixel.y));
            enveloped = pixel.y;
            distances.push_back(std::sqrt(static_cast<double>(squaredDistance(pixel.x - box_.x0))));
        }
        return distances;
    }

  private:
    static constexpr int kNone = std::numeric_limits<int>::max(); // no pixel of the contour in this column

    /// (x - column)^2 + height, the lowest of all from `begin` to the next one's.
    struct Parabola {
        int column;
        int64_t height;
        double begin;
    };

    int* row(int y) {
        return inColumn_.data() + static_cast<size_t>(y - box_.y0) * static_cast<size_t>(box_.width());
    }

    void spread(const int* from, int* to) const {
        for (int x = 0; x < box_.width(); ++x)
            if (from[x] != kNone) to[x] = std::min(to[x], from[x] + 1);
    }

    /// Doubles are exact enough: a crossing is a fraction of integers below 2^53, so it never rounds past a whole x that it
    /// isn't equal to, and where it is equal both parabolas give the same.
    void buildEnvelope(const int* inColumn) {
        envelope_.clear();
        for (int x = 0; x < box_.width(); ++x) {
            if (inColumn[x] == kNone) continue;
            const int64_t height = int64_t(inColumn[x]) * inColumn[x];
            double begin = -std::numeric_limits<double>::infinity();
            while (!envelope_.empty()) {
                const Parabola& last = envelope_.back();
                const int64_t rise =
                    height + int64_t(x) * x - last.height - int64_t(last.column) * last.column;
                begin = static_cast<double>(rise) / (2.0 * (x - last.column));
                if (begin > last.begin) break;
                envelope_.pop_back();
                begin = -std::numeric_limits<double>::infinity();
            }
            envelope_.push_back({x, height, begin});
        }
    }

    /// In the row whose envelope was built.
    int64_t squaredDistance(int x) const {
        const auto next = std::partition_point(envelope_.begin(), envelope_.end(),
                                               [x](const Parabola& parabola) { return parabola.begin <= x; });
        const Parabola& lowest = *std::prev(next); // the first begins at -infinity
        const int64_t aside = x - lowest.column;
        return aside * aside + lowest.height;
    }

    Box box_;
    std::vector<int>
        inColumn_; // per pixel of the box: distance to the nearest pixel of the contour above or below
    std::vector<Parabola> envelope_;
};

/// Empty if both frames have a contour.
std::string noContourReason(const ContourDistance& result) {
    if (result.referencePx > 0 && result.testPx > 0) return {};
    return fmt::format("{} no outline of it: nothing of it, or nothing beside it",
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
    Box box;
    box.include(inReference);
    box.include(inTest);
    const std::vector<double> there = DistanceField(inTest, box).distancesOf(inReference);
    const std::vector<double> back = DistanceField(inReference, box).distancesOf(inTest);
    const double sum =
        std::accumulate(there.begin(), there.end(), 0.0) + std::accumulate(back.begin(), back.end(), 0.0);
    result.meanPx = sum / static_cast<double>(there.size() + back.size());
    result.hausdorff95Px = std::max(nearestRank(there, 95), nearestRank(back, 95));
    return result;
}

MetricValues valuesOf(const ContourDistance& result) {
    return {{"contour_mean_px", result.meanPx},
            {"hausdorff95_px", result.hausdorff95Px},
            {"contour_reference_px", result.referencePx},
            {"contour_test_px", result.testPx}};
}

} // namespace plumbline
