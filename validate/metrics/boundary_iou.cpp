#include "validate/metrics/boundary_iou.h"

#include "validate/metrics/distance_transform.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr size_t kWidthCount = kBoundaryWidths.size();

/// Largest squared distance in the rim of each width, in pixels squared. Squared distances are integers, so
/// that of 2 % of the diagonal is rounded down.
using SquaredWidths = std::array<int64_t, kWidthCount>;

SquaredWidths squaredWidths(int width, int height) {
    const int64_t diagonal = int64_t(width) * width + int64_t(height) * height;
    return {1, 4, 16, std::max<int64_t>(1, diagonal / 2500)}; // 0.02^2 = 1/2500
}

/// Bit w: the pixel is in the rim of width w.
using RimBits = std::vector<uint8_t>;

/// Finds the rims of masks. `pixels`: ascending, contains every pixel of each mask.
class RimFinder {
  public:
    RimFinder(const FramePair& pair, std::span<const uint32_t> pixels)
        : pixels_(pixels), width_(pair.reference().width()), height_(pair.reference().height()),
          limits_(squaredWidths(width_, height_)),
          reach_(static_cast<int>(
              std::sqrt(static_cast<double>(*std::max_element(limits_.begin(), limits_.end()))))) {}

    Pixel placeOf(uint32_t pixel) const {
        const auto stride = static_cast<uint32_t>(width_);
        return {static_cast<int>(pixel % stride), static_cast<int>(pixel / stride)};
    }
    /// Width of the widest rim, in pixels.
    int reach() const { return reach_; }

    /// Per pixel of the list; 0 outside the mask. `inside(pixel)`: whether any pixel of the image is in it.
    ///
    /// Only pixels outside the mask with a 4-neighbor in it are needed: the nearest outside pixel has one,
    /// because a step from it toward the mask's pixel is nearer and therefore inside.
    template <class Inside>
    RimBits find(const Inside& inside) const {
        std::vector<Pixel> mask, outside;
        PixelBox box;
        mask.reserve(pixels_.size());
        for (const uint32_t pixel : pixels_) {
            if (!inside(pixel)) continue;
            const Pixel place = placeOf(pixel);
            mask.push_back(place);
            box.include(place);
            const auto stride = static_cast<uint32_t>(width_);
            if (place.x > 0 && !inside(pixel - 1)) outside.push_back({place.x - 1, place.y});
            if (place.x + 1 < width_ && !inside(pixel + 1)) outside.push_back({place.x + 1, place.y});
            if (place.y > 0 && !inside(pixel - stride)) outside.push_back({place.x, place.y - 1});
            if (place.y + 1 < height_ && !inside(pixel + stride)) outside.push_back({place.x, place.y + 1});
        }
        RimBits bits(pixels_.size());
        if (outside.empty()) return bits; // an empty mask, or one that fills the image
        box.include(outside);
        const std::vector<int64_t> distances =
            DistanceTransform(outside, box, reach_).squaredDistancesOf(mask);
        size_t next = 0;
        for (size_t i = 0; i < pixels_.size(); ++i)
            if (inside(pixels_[i])) bits[i] = bitsOf(distances[next++]);
        return bits;
    }

  private:
    uint8_t bitsOf(int64_t squaredDistance) const {
        unsigned bits = 0;
        for (size_t width = 0; width < kWidthCount; ++width)
            bits |= unsigned(squaredDistance <= limits_[width]) << width;
        return static_cast<uint8_t>(bits);
    }

    std::span<const uint32_t> pixels_;
    int width_, height_;
    SquaredWidths limits_;
    int reach_;
};

/// Pixels that show the object in either frame, and uncertain pixels, which might. Ascending.
std::vector<uint32_t> pixelsAround(const FramePair& pair, size_t index) {
    const auto shown = pair.pixelsOf(index), uncertain = pair.uncertainPixels();
    std::vector<uint32_t> pixels;
    pixels.reserve(shown.size() + uncertain.size());
    std::set_union(shown.begin(), shown.end(), uncertain.begin(), uncertain.end(),
                   std::back_inserter(pixels));
    return pixels;
}

/// The certain and the possible rims of the header, at pixels that aren't uncertain.
struct TrueRims {
    RimBits certain, possible;
};

/// With the masks A = R \ U and B = R u U of the header, outside U the certain rim is rim(B) and the possible
/// rim is rim(A).
TrueRims findTrueRims(const FramePair& pair, int id, const RimFinder& finder,
                      std::span<const uint32_t> pixels) {
    const auto certain = [&](uint32_t pixel) {
        return pair.referenceIds()[pixel] == id && !pair.isUncertain(pixel);
    };
    // Pixels farther from A than the widest rim don't change it, so B is evaluated around A only.
    PixelBox near;
    for (const uint32_t pixel : pixels)
        if (certain(pixel)) near.include(finder.placeOf(pixel));
    const int margin = finder.reach() + 1;
    const auto isNear = [&](uint32_t pixel) {
        const Pixel place = finder.placeOf(pixel);
        return place.x >= near.x0 - margin && place.x < near.x1 + margin && place.y >= near.y0 - margin &&
               place.y < near.y1 + margin;
    };
    const bool none = near.x1 == 0;
    TrueRims rims;
    rims.possible = finder.find(certain);
    rims.certain = none ? RimBits(pixels.size()) : finder.find([&](uint32_t pixel) {
        return certain(pixel) || (pair.isUncertain(pixel) && isNear(pixel));
    });
    return rims;
}

Outcomes outcomesOf(bool certain, bool possible, bool inTest) {
    Outcomes outcomes;
    if (possible) (inTest ? outcomes.hit : outcomes.miss) = true;
    if (!certain) (inTest ? outcomes.miss : outcomes.nothing) = true;
    return outcomes;
}

BoundaryRims findRims(const FramePair& pair, size_t index) {
    const int id = pair.objects()[index].id;
    const std::vector<uint32_t> pixels = pixelsAround(pair, index);
    const RimFinder finder(pair, pixels);
    RimBits reference, test;
    TrueRims trueRims;
    tbb::parallel_invoke(
        [&] { reference = finder.find([&](uint32_t pixel) { return pair.referenceIds()[pixel] == id; }); },
        [&] { test = finder.find([&](uint32_t pixel) { return pair.testIds()[pixel] == id; }); },
        [&] {
            if (!pair.uncertainPixels().empty()) trueRims = findTrueRims(pair, id, finder, pixels);
        });
    if (pair.uncertainPixels().empty()) trueRims = {reference, reference};

    BoundaryRims rims;
    for (size_t width = 0; width < kWidthCount; ++width) {
        BoundaryRims::AtWidth& sums = rims.at[width];
        const auto has = [&](uint8_t bits) { return (bits >> width & 1) != 0; };
        for (size_t i = 0; i < pixels.size(); ++i) {
            sums.intersectionPx += has(reference[i] & test[i]);
            sums.unionPx += has(reference[i] | test[i]);
            if (pair.isUncertain(pixels[i]))
                sums.uncertainTestPx += has(test[i]);
            else
                sums.certain.add(
                    outcomesOf(has(trueRims.certain[i]), has(trueRims.possible[i]), has(test[i])));
        }
    }
    return rims;
}

/// Adds the `allPx` uncertain pixels, of which `inTestPx` are in a rim of the test.
void addUncertain(RatioRange& range, uint64_t inTestPx, uint64_t allPx, bool severalSelected) {
    Outcomes inTest, elsewhere;
    inTest.hit = inTest.miss = elsewhere.nothing = elsewhere.miss = true;
    inTest.twoMisses = severalSelected;
    for (uint64_t i = 0; i < allPx; ++i)
        range.add(i < inTestPx ? inTest : elsewhere);
}

} // namespace

std::vector<BoundaryRims> findBoundaryRims(const FramePair& pair) {
    std::vector<BoundaryRims> rims(pair.objects().size());
    tbb::parallel_for(size_t(0), rims.size(), [&](size_t index) { rims[index] = findRims(pair, index); });
    return rims;
}

BoundaryIou computeBoundaryIou(const FramePair& pair, ObjectSelection selection,
                               std::span<const BoundaryRims> rims) {
    BoundaryIou result;
    const std::string noRange = pair.missingInReference("uncertain");
    for (size_t width = 0; width < kWidthCount; ++width) {
        BoundaryIou::AtWidth& at = result.at[width];
        RatioRange range;
        uint64_t uncertainTestPx = 0;
        for (const size_t index : selection) {
            const BoundaryRims::AtWidth& ofObject = rims[index].at[width];
            at.intersectionPx += ofObject.intersectionPx;
            at.unionPx += ofObject.unionPx;
            range.add(ofObject.certain);
            uncertainTestPx += ofObject.uncertainTestPx;
        }
        at.iou = Figure::ratio(at.intersectionPx, at.unionPx, "neither frame shows an outline of it");
        addUncertain(range, uncertainTestPx, pair.uncertainPixels().size(), selection.size() > 1);
        at.range = noRange.empty() ? range.of(at.iou) : Interval::absent(noRange);
    }
    return result;
}

namespace {

/// The rows of one width. `width`: an index into kBoundaryWidths.
void appendRows(std::vector<FigureRow<BoundaryIou>>& rows, size_t width) {
    const std::string name = kBoundaryWidths[width];
    const bool widest = name == "2pct";
    const std::string label = widest ? "boundary IoU 2 %" : "boundary IoU " + name;
    MetricInfo iou{.key = name,
                   .label = label,
                   .unit = Unit::Ratio,
                   .goal = Goal::One,
                   .meaning = "IoU of the rims of the two silhouettes, " +
                              (widest ? std::string("d = 2 % of the image diagonal, at least 1 px")
                                      : "d = " + name.substr(0, name.find('p')) + " px"),
                   .formula = "Σ|R_d∩T_d| / Σ|R_d∪T_d|, sums over the objects",
                   .source = "Cheng et al. 2021, CVPR, Eq. 4"};
    if (widest) iou.report = {"boundary IoU", "2 % of diagonal", "{:.4f}"};
    rows.push_back({iou,
                    [width](const BoundaryIou& result) { return result.at[width].iou; },
                    {[width](const BoundaryIou& result) { return result.at[width].range; },
                     {"lower bound of it over all true images that the reference's uncertain pixels allow",
                      "upper bound of it over these images"}}});
    rows.push_back({{.key = name + "_intersection_px",
                     .label = label + ", in both",
                     .unit = Unit::PixelCount,
                     .meaning = "its numerator",
                     .formula = "Σ|R_d∩T_d|"},
                    [width](const BoundaryIou& result) { return result.at[width].intersectionPx; }});
    rows.push_back({{.key = name + "_union_px",
                     .label = label + ", in either",
                     .unit = Unit::PixelCount,
                     .meaning = "its denominator",
                     .formula = "Σ|R_d∪T_d|"},
                    [width](const BoundaryIou& result) { return result.at[width].unionPx; }});
}

} // namespace

Metric boundaryIouMetric() {
    std::vector<FigureRow<BoundaryIou>> rows;
    for (size_t width = 0; width < kWidthCount; ++width)
        appendRows(rows, width);
    return makeMetric<BoundaryIou>({
        .group = "silhouette.boundary_iou",
        .domain = "rims R_d, T_d: pixels of the object with a pixel of the image outside it at most d away",
        .rows = std::move(rows),
        .prepare =
            [](const MetricInput& input) {
                return [&pair = input.pair, rims = findBoundaryRims(input.pair)](ObjectSelection selection) {
                    return computeBoundaryIou(pair, selection, rims);
                };
            },
    });
}

} // namespace plumbline
