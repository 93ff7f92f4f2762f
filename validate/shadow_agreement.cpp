#include "shadow_agreement.h"

#include <cmath>

namespace plumbline {
namespace {

constexpr float kShadowThreshold = 0.5f;

void countPixels(const FramePair& pair, ObjectSelection selection, const std::string& channel,
                 ShadowAgreement& result) {
    const auto reference = pair.reference().channel(channel), test = pair.test().channel(channel);
    forSharedPixels(pair, selection, [&](uint32_t pixel, const ObjectInfo&) {
        if (!std::isfinite(reference[pixel]) || !std::isfinite(test[pixel])) {
            ++result.invalidPx;
            return;
        }
        const bool dark = reference[pixel] >= kShadowThreshold, darkInTest = test[pixel] >= kShadowThreshold;
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

} // namespace

ShadowAgreement computeShadowAgreement(const FramePair& pair, ObjectSelection selection,
                                       const std::string& light) {
    ShadowAgreement result;
    const std::string channel = shadowChannel(light);
    std::string reason = pair.missingChannel(channel);
    if (reason.empty()) {
        countPixels(pair, selection, channel, result);
        if (result.domainPx == 0)
            reason = result.invalidPx > 0 ? "no shared pixel has a finite shadow value in both frames"
                                          : "no pixel is covered by the same object in both frames";
    }
    if (!reason.empty()) {
        result.agreement = result.iou = result.f1 = result.ber = Figure::absent(reason);
        return result;
    }
    const uint64_t wrong = result.falseShadowPx + result.falseLitPx;
    const std::string noShadow = "neither frame has a shadow in the domain";
    result.agreement = Figure::ratio(result.bothShadowPx + result.bothLitPx, result.domainPx, reason);
    result.iou = Figure::ratio(result.bothShadowPx, result.bothShadowPx + wrong, noShadow);
    result.f1 = Figure::ratio(2 * result.bothShadowPx, 2 * result.bothShadowPx + wrong, noShadow);
    result.ber = balancedErrorRate(result);
    return result;
}

MetricValues valuesOf(const ShadowAgreement& result) {
    return {{"domain_px", result.domainPx},
            {"agreement", result.agreement},
            {"iou", result.iou},
            {"f1", result.f1},
            {"ber", result.ber},
            {"false_shadow_px", result.falseShadowPx},
            {"false_lit_px", result.falseLitPx},
            {"both_shadow_px", result.bothShadowPx},
            {"both_lit_px", result.bothLitPx},
            {"invalid_px", result.invalidPx}};
}

} // namespace plumbline
