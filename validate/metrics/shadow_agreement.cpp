#include "validate/metrics/shadow_agreement.h"

namespace plumbline {
namespace {

void countPixels(const FramePair& pair, ObjectSelection selection, const std::string& light,
                 ShadowAgreement& result) {
    result.invalidPx = forShadowPixels(pair, selection, light, [&](uint32_t, bool dark, bool darkInTest) {
        ++result.domainPx;
        result.bothShadowPx += dark && darkInTest;
        result.bothLitPx += !dark && !darkInTest;
        result.falseShadowPx += !dark && darkInTest;
        result.falseLitPx += dark && !darkInTest;
    });
}

Figure balancedErrorRate(const ShadowAgreement& result) {
    const uint64_t lit = result.bothLitPx + result.falseShadowPx,
                   dark = result.bothShadowPx + result.falseLitPx;
    if (lit == 0) return Figure::absent("no pixel of the domain is lit in the reference");
    if (dark == 0) return Figure::absent("no pixel of the domain is in shadow in the reference");
    return {0.5 * (static_cast<double>(result.falseShadowPx) / static_cast<double>(lit) +
                   static_cast<double>(result.falseLitPx) / static_cast<double>(dark))};
}

/// Computes the figures from the counts.
void computeFigures(ShadowAgreement& result) {
    if (result.domainPx == 0) {
        result.agreement = result.iou = result.f1 = result.ber =
            Figure::absent(result.invalidPx > 0 ? "no shared pixel has a finite shadow value in both frames"
                                                : "no pixel is covered by the same object in both frames");
        return;
    }
    const uint64_t wrong = result.falseShadowPx + result.falseLitPx;
    const std::string noShadow = "neither frame has a shadow in the domain";
    result.agreement = Figure::ratio(result.bothShadowPx + result.bothLitPx, result.domainPx, "");
    result.iou = Figure::ratio(result.bothShadowPx, result.bothShadowPx + wrong, noShadow);
    result.f1 = Figure::ratio(2 * result.bothShadowPx, 2 * result.bothShadowPx + wrong, noShadow);
    result.ber = balancedErrorRate(result);
}

/// Outcomes that a pixel may have in agreement and in IoU.
struct PixelOutcomes {
    Outcomes agreement, iou;
    void allow(bool dark, bool darkInTest) {
        (dark == darkInTest ? agreement.hit : agreement.miss) = true;
        if (!dark && !darkInTest)
            iou.nothing = true;
        else
            (dark == darkInTest ? iou.hit : iou.miss) = true;
    }
    void allowOutside() { agreement.nothing = iou.nothing = true; }
};

/// Computes the ranges and the number of uncertain pixels. The reference must have both channels.
void computeRanges(const FramePair& pair, ObjectSelection selection, const std::string& light,
                   ShadowAgreement& result) {
    const auto reference = pair.reference().channel(shadowChannel(light));
    const auto test = pair.test().channel(shadowChannel(light));
    const auto uncertainShadow = pair.reference().channel(uncertainShadowChannel(light));
    RatioRange agreement, iou;
    for (const size_t index : selection) {
        const int id = pair.objects()[index].id;
        for (const uint32_t pixel : pair.pixelsOf(index)) {
            if (pair.testIds()[pixel] != id || !std::isfinite(test[pixel])) continue; // never in the domain
            const bool known = pair.referenceIds()[pixel] == id && std::isfinite(reference[pixel]);
            const bool uncertain = pair.isUncertain(pixel);
            const bool dark = isShadow(reference[pixel]), darkInTest = isShadow(test[pixel]);
            PixelOutcomes outcomes;
            if (!known || uncertain) outcomes.allowOutside();
            if (known) outcomes.allow(dark, darkInTest);
            if (known ? saysUncertain(uncertainShadow[pixel]) : uncertain) {
                outcomes.allow(false, darkInTest);
                outcomes.allow(true, darkInTest);
            }
            agreement.add(outcomes.agreement);
            iou.add(outcomes.iou);
        }
    }
    result.agreementRange = agreement.of(result.agreement);
    result.iouRange = iou.of(result.iou);
    result.f1Range = iou.of(result.f1, 2);
    // Every uncertain pixel has several outcomes in agreement, but not always in IoU.
    result.uncertainPx = static_cast<double>(agreement.uncertainPx());
}

void setNoRanges(const std::string& reason, ShadowAgreement& result) {
    result.agreementRange = result.iouRange = result.f1Range = Interval::absent(reason);
    result.uncertainPx = Figure::absent(reason);
}

} // namespace

ShadowAgreement computeShadowAgreement(const FramePair& pair, ObjectSelection selection,
                                       const std::string& light) {
    ShadowAgreement result;
    if (const std::string missing = pair.missingChannel(shadowChannel(light)); !missing.empty()) {
        result.agreement = result.iou = result.f1 = result.ber = Figure::absent(missing);
        setNoRanges(missing, result);
        return result;
    }
    countPixels(pair, selection, light, result);
    computeFigures(result);
    std::string noRange = pair.missingInReference("uncertain");
    if (noRange.empty()) noRange = pair.missingInReference(uncertainShadowChannel(light));
    if (noRange.empty())
        computeRanges(pair, selection, light, result);
    else
        setNoRanges(noRange, result);
    return result;
}

Metric shadowAgreementMetric() {
    return makeMetric<ShadowAgreement>({
        .group = "shadow",
        .domain = kSharedDomain,
        .scope = Scope::ObjectsByLight,
        .rows = {{{.key = "domain_px",
                   .label = "shadow compared",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels compared; a value >= 0.5 is shadow"},
                  &ShadowAgreement::domainPx},
                 {{.key = "agreement",
                   .label = "shadow agreement",
                   .unit = Unit::Ratio,
                   .goal = Goal::One,
                   .meaning = "share of the domain where both are lit or both in shadow",
                   .formula = "(TP + TN) / (TP + TN + FP + FN)",
                   .table = {{"shadow", 4}},
                   .report = {{"shadow agreement", "", "{:.4f}"}}},
                  &ShadowAgreement::agreement,
                  {&ShadowAgreement::agreementRange,
                   {"lowest agreement over all true images that the reference's uncertain pixels allow",
                    "highest agreement over them"}}},
                 {{.key = "iou",
                   .label = "shadow IoU",
                   .unit = Unit::Ratio,
                   .goal = Goal::One,
                   .meaning = "pixels in shadow in both frames / in either",
                   .formula = "TP / (TP + FP + FN)",
                   .source = "Jaccard 1901"},
                  &ShadowAgreement::iou,
                  {&ShadowAgreement::iouRange,
                   {"lowest IoU over all true images that uncertain pixels allow", "highest IoU over them"}}},
                 {{.key = "f1",
                   .label = "shadow F1",
                   .unit = Unit::Ratio,
                   .goal = Goal::One,
                   .meaning = "harmonic mean of the test's precision and recall on shadow",
                   .formula = "2 TP / (2 TP + FP + FN)",
                   .source = "Dice 1945"},
                  &ShadowAgreement::f1,
                  {&ShadowAgreement::f1Range,
                   {"lowest F1 over all true images that uncertain pixels allow", "highest F1 over them"}}},
                 {{.key = "ber",
                   .label = "shadow error rate",
                   .unit = Unit::Ratio,
                   .goal = Goal::Zero,
                   .meaning = "balanced error rate: mean of the error rates on lit and on dark pixels",
                   .formula = "½ (FP / (TN + FP) + FN / (TP + FN))",
                   .table = {{"BER", 4}},
                   .report = {{"shadow error rate", "balanced", "{:.4f}"}}},
                  &ShadowAgreement::ber},
                 {{.key = "false_shadow_px",
                   .label = "false shadow",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "lit in the reference, in shadow in the test",
                   .formula = "FP"},
                  &ShadowAgreement::falseShadowPx},
                 {{.key = "false_lit_px",
                   .label = "false lit",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "in shadow in the reference, lit in the test",
                   .formula = "FN"},
                  &ShadowAgreement::falseLitPx},
                 {{.key = "both_shadow_px",
                   .label = "shadow in both",
                   .unit = Unit::PixelCount,
                   .meaning = "in shadow in both",
                   .formula = "TP"},
                  &ShadowAgreement::bothShadowPx},
                 {{.key = "both_lit_px",
                   .label = "lit in both",
                   .unit = Unit::PixelCount,
                   .meaning = "lit in both",
                   .formula = "TN"},
                  &ShadowAgreement::bothLitPx},
                 {{.key = "invalid_px",
                   .label = "without shadow",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "shared pixels without a finite shadow value in both: not in the domain"},
                  &ShadowAgreement::invalidPx},
                 {{.key = "uncertain_px",
                   .label = "uncertain",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels of the test whose shadow in the reference, or membership in the "
                              "domain, is uncertain"},
                  &ShadowAgreement::uncertainPx}},
        .compute =
            [](const MetricInput& input, ObjectSelection selection, const std::string& light) {
                return computeShadowAgreement(input.pair, selection, light);
            },
    });
}

} // namespace plumbline
