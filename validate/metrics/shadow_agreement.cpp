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

/// The figures from the counts.
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

/// What a pixel may add to agreement and to IoU.
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

/// The ranges and the count of pixels they come from. Both channels must be there.
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
    // Whatever is uncertain about a pixel shows in its agreement; of its share in IoU not always.
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

MetricValues valuesOf(const ShadowAgreement& result) {
    return {{"domain_px", result.domainPx},
            {"agreement", result.agreement},
            {"agreement_low", result.agreementRange.low},
            {"agreement_high", result.agreementRange.high},
            {"iou", result.iou},
            {"iou_low", result.iouRange.low},
            {"iou_high", result.iouRange.high},
            {"f1", result.f1},
            {"f1_low", result.f1Range.low},
            {"f1_high", result.f1Range.high},
            {"ber", result.ber},
            {"false_shadow_px", result.falseShadowPx},
            {"false_lit_px", result.falseLitPx},
            {"both_shadow_px", result.bothShadowPx},
            {"both_lit_px", result.bothLitPx},
            {"invalid_px", result.invalidPx},
            {"uncertain_px", wholeNumber(result.uncertainPx)}};
}

} // namespace plumbline
