#include "validate/results/certificate.h"

#include "scenes/frame/header_fields.h"
#include "validate/metrics/frame_pair.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

Figure countWhere(const Frame& frame, const std::string& channel, bool (*counts)(float)) {
    if (!frame.has(channel))
        return Figure::absent(fmt::format("the reference frame has no channel {}", channel));
    const auto plane = frame.channel(channel);
    return {static_cast<double>(std::count_if(plane.begin(), plane.end(), counts))};
}

bool isCovered(float coverageOrId) {
    return coverageOrId >= 0.5f;
}

/// "134", or "unknown" with nothing said of why: the reason stands in results.json.
std::string shownCount(const Figure& count) {
    return count ? fmt::format("{:.0f}", *count) : "unknown";
}

std::string shadowCounts(const CertificateSummary& certificate) {
    std::string text;
    for (const auto& [light, count] : certificate.uncertainShadowPixels)
        text += fmt::format("{} {} {}", text.empty() ? "" : ",", light, shownCount(count));
    return text;
}

} // namespace

Figure CertificateSummary::figure(const CertificateRow& row) const {
    if (const Certificate::Number& number = error.*row.number) return {*number};
    return Figure::absent(reasonWithout(row.key));
}

Figure CertificateSummary::figure(Certificate::Number Certificate::*number) const {
    return figure(*std::ranges::find(certificateTable(), number, &CertificateRow::number));
}

std::string CertificateSummary::reasonWithout(std::string_view key) const {
    if (!unknownReason.empty()) return unknownReason;
    return fmt::format("the reference's file has no header field {}", header::certificate(key));
}

CertificateSummary summaryOf(const Certificate& measured, const Frame& reference) {
    CertificateSummary summary;
    summary.error = measured;
    summary.unknownReason = "the reference didn't measure it";
    countPixels(reference, summary);
    return summary;
}

CertificateSummary certificateFromHeader(const Frame& reference, const std::string& where) {
    CertificateSummary summary;
    summary.error = readCertificate(reference.metadata, where);
    countPixels(reference, summary);
    return summary;
}

void setAbsent(CertificateSummary& certificate, const std::string& reason) {
    certificate.error = {};
    certificate.unknownReason = reason;
}

void countPixels(const Frame& reference, CertificateSummary& certificate) {
    certificate.coveredPixels = countWhere(reference, reference.has("id") ? "id" : "A", isCovered);
    certificate.uncertainPixels = countWhere(reference, "uncertain", saysUncertain);
    for (const std::string& light : reference.lightNames())
        certificate.uncertainShadowPixels[light] =
            countWhere(reference, uncertainShadowChannel(light), saysUncertain);
    if (certificate.coveredPixels && *certificate.coveredPixels == 0)
        setAbsent(certificate, "no pixel shows the surface");
}

std::string certificateLine(const CertificateSummary& certificate, const std::string& of) {
    const CertificateSummary& c = certificate;
    const Figure pxP99 = c.figure(&Certificate::pxP99), worldP99 = c.figure(&Certificate::worldP99);
    std::string line = fmt::format("certificate{}: ", of);
    if (!pxP99)
        line += fmt::format("none: {}", pxP99.reason());
    else {
        const auto px = [&](Certificate::Number Certificate::*number) {
            const Figure figure = c.figure(number);
            return figure ? fmt::format("{:.3g} px", *figure) : std::string("unknown");
        };
        line += fmt::format("error p50 {}, p99 {}, max {} (aim {} at p99)", px(&Certificate::pxP50),
                            px(&Certificate::pxP99), px(&Certificate::pxMax), px(&Certificate::pxAim));
        if (worldP99) line += fmt::format("; world p99 {:.2g}", *worldP99);
    }
    if (c.uncertainPixels) {
        line += fmt::format("; uncertain {} pixels ({} covered)", shownCount(c.uncertainPixels),
                            shownCount(c.coveredPixels));
        if (!c.uncertainShadowPixels.empty()) line += ", shadow" + shadowCounts(c);
    }
    if (c.error.limit && !c.error.limit->empty())
        line += fmt::format("; the aim isn't met: {}", *c.error.limit);
    return line;
}

std::vector<std::string> certificateSentences(const CertificateSummary& certificate) {
    const CertificateSummary& c = certificate;
    const Figure pxP50 = c.figure(&Certificate::pxP50), pxP99 = c.figure(&Certificate::pxP99),
                 pxMax = c.figure(&Certificate::pxMax), pxAim = c.figure(&Certificate::pxAim);
    const Figure worldP50 = c.figure(&Certificate::worldP50), worldP99 = c.figure(&Certificate::worldP99),
                 worldMax = c.figure(&Certificate::worldMax);
    std::vector<std::string> sentences;
    if (!pxP99)
        sentences.push_back(fmt::format(
            "How far the reference itself is from the true surface isn't known: {}.", pxP99.reason()));
    else if (pxP50 && pxMax && pxAim)
        sentences.push_back(
            fmt::format("The reference's own error, measured in the pixels that show the surface: half of "
                        "them are within "
                        "{:.3g} px of it, 99 % within {:.3g} px (the aim: {:.3g} px), all within {:.3g} px.",
                        *pxP50, *pxP99, *pxAim, *pxMax));
    else
        sentences.push_back(fmt::format(
            "The reference's own error: 99 % of the pixels that show the surface are within {:.3g} px of it.",
            *pxP99));
    if (worldP50 && worldP99 && worldMax)
        sentences.push_back(
            fmt::format("In world units: {:.2g}, {:.2g} and {:.2g}.", *worldP50, *worldP99, *worldMax));
    if (c.error.limit && !c.error.limit->empty())
        sentences.push_back(fmt::format("The aim isn't met: {}.", *c.error.limit));
    if (c.uncertainPixels)
        sentences.push_back(fmt::format(
            "That error could change which object is seen in {} pixels ({} are covered){}.",
            shownCount(c.uncertainPixels), shownCount(c.coveredPixels),
            c.uncertainShadowPixels.empty() ? ""
                                            : ", and whether it is in shadow, by light:" + shadowCounts(c)));
    else
        sentences.push_back(fmt::format("In which pixels that could change what is seen isn't known: {}.",
                                        c.uncertainPixels.reason()));
    return sentences;
}

} // namespace plumbline
