#include "validate/metrics/silhouette_iou.h"

#include <set>

namespace plumbline {
namespace {

std::set<int> idsOf(const FramePair& pair, ObjectSelection selection) {
    std::set<int> ids;
    for (const size_t index : selection)
        ids.insert(pair.objects()[index].id);
    return ids;
}

/// Outcome of a certain pixel, at which the true image shows what the reference shows.
Outcomes certainOutcome(bool referenceSelected, bool testSelected, bool same) {
    Outcomes outcome;
    if (!referenceSelected && !testSelected)
        outcome.nothing = true;
    else if (!referenceSelected || !testSelected)
        outcome.miss = true;
    else
        (same ? outcome.hit : outcome.twoMisses) = true;
    return outcome;
}

Outcomes uncertainOutcomes(bool testSelected, bool severalSelected) {
    Outcomes outcomes;
    outcomes.miss = true;
    if (testSelected) {
        outcomes.hit = true;
        outcomes.twoMisses = severalSelected;
    } else {
        outcomes.nothing = true;
    }
    return outcomes;
}

/// Adds every pixel that contributes to the sums or might.
RatioRange rangeOfIou(const FramePair& pair, ObjectSelection selection) {
    const std::set<int> ids = idsOf(pair, selection);
    RatioRange range;
    for (const size_t index : selection) {
        const int id = pair.objects()[index].id;
        for (const uint32_t pixel : pair.pixelsOf(index)) {
            const int inReference = pair.referenceIds()[pixel], inTest = pair.testIds()[pixel];
            const bool referenceSelected = ids.contains(inReference), testSelected = ids.contains(inTest);
            // A pixel at which the frames show different objects of the selection is listed with both. It is
            // counted once, with the reference's.
            const bool elsewhere = referenceSelected && id != inReference;
            if (!elsewhere && !pair.isUncertain(pixel))
                range.add(certainOutcome(referenceSelected, testSelected, inReference == inTest));
        }
    }
    for (const uint32_t pixel : pair.uncertainPixels())
        range.add(uncertainOutcomes(ids.contains(pair.testIds()[pixel]), ids.size() > 1));
    return range;
}

} // namespace

SilhouetteIou computeSilhouetteIou(const FramePair& pair, ObjectSelection selection) {
    SilhouetteIou result;
    const std::string noSides = pair.missingInReference("facing");
    const auto facing = noSides.empty() ? pair.reference().channel("facing") : std::span<const float>();
    uint64_t backPx = 0, missingBackPx = 0;
    for (const size_t index : selection) {
        const int id = pair.objects()[index].id;
        for (const uint32_t pixel : pair.pixelsOf(index)) {
            const bool inReference = pair.referenceIds()[pixel] == id, inTest = pair.testIds()[pixel] == id;
            result.referencePx += inReference;
            result.testPx += inTest;
            result.intersectionPx += inReference && inTest;
            result.missingPx += inReference && !inTest;
            result.extraPx += inTest && !inReference;
            const bool back = inReference && !facing.empty() && facing[pixel] < 0;
            backPx += back;
            missingBackPx += back && !inTest;
        }
    }
    result.unionPx = result.intersectionPx + result.missingPx + result.extraPx;
    result.iou = Figure::ratio(result.intersectionPx, result.unionPx, "neither frame shows it");
    result.backPx = noSides.empty() ? Figure(static_cast<double>(backPx)) : Figure::absent(noSides);
    result.missingBackPx =
        noSides.empty() ? Figure(static_cast<double>(missingBackPx)) : Figure::absent(noSides);

    if (const std::string reason = pair.missingInReference("uncertain"); !reason.empty()) {
        result.iouRange = Interval::absent(reason);
        result.uncertainPx = Figure::absent(reason);
        return result;
    }
    const RatioRange range = rangeOfIou(pair, selection);
    result.iouRange = range.of(result.iou);
    result.uncertainPx = static_cast<double>(range.uncertainPx());
    return result;
}

Metric silhouetteIouMetric() {
    return makeMetric<SilhouetteIou>({
        .group = "silhouette",
        .domain = "all pixels; R and T: those that show the object in reference and test",
        .rows = {{{.key = "iou",
                   .label = "silhouette IoU",
                   .unit = Unit::Ratio,
                   .goal = Goal::One,
                   .meaning = "pixels that show the object in both frames / in either",
                   .formula = "Σ|R∩T| / Σ|R∪T|, sums over the objects",
                   .source = "Jaccard 1901",
                   .table = {{"IoU", 5}},
                   .report = {{"silhouette IoU", "", "{:.5f}"}}},
                  &SilhouetteIou::iou,
                  {&SilhouetteIou::iouRange,
                   {"lowest IoU over all true images that the reference's uncertain pixels allow",
                    "highest IoU over them"}}},
                 {{.key = "missing_px",
                   .label = "missing",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "pixels that should show the object and don't",
                   .formula = "Σ|R∖T|",
                   .table = {{"miss", 0}},
                   .report = {{"missing", "px", "{:.0f}"}}},
                  &SilhouetteIou::missingPx},
                 {{.key = "extra_px",
                   .label = "extra",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "pixels that show the object and shouldn't",
                   .formula = "Σ|T∖R|",
                   .table = {{"extra", 0}},
                   .report = {{"extra", "px", "{:.0f}"}}},
                  &SilhouetteIou::extraPx},
                 {{.key = "back_px",
                   .label = "back side",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels that show the back side of the object in the reference",
                   .formula = "Σ|B|, B: pixels of R that face away"},
                  &SilhouetteIou::backPx},
                 {{.key = "missing_back_px",
                   .label = "missing, back side",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "those of missing_px at which the reference shows the back side",
                   .formula = "Σ|B∖T|"},
                  &SilhouetteIou::missingBackPx},
                 {{.key = "reference_px",
                   .label = "in the reference",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels of the object in the reference",
                   .formula = "Σ|R|"},
                  &SilhouetteIou::referencePx},
                 {{.key = "test_px",
                   .label = "in the test",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels of the object in the test",
                   .formula = "Σ|T|"},
                  &SilhouetteIou::testPx},
                 {{.key = "intersection_px",
                   .label = "in both",
                   .unit = Unit::PixelCount,
                   .meaning = "numerator of iou",
                   .formula = "Σ|R∩T|"},
                  &SilhouetteIou::intersectionPx},
                 {{.key = "union_px",
                   .label = "in either",
                   .unit = Unit::PixelCount,
                   .meaning = "denominator of iou",
                   .formula = "Σ|R∪T|"},
                  &SilhouetteIou::unionPx},
                 {{.key = "uncertain_px",
                   .label = "uncertain",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels at which the reference is uncertain about the visible object"},
                  &SilhouetteIou::uncertainPx}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeSilhouetteIou(input.pair, selection); },
    });
}

} // namespace plumbline
