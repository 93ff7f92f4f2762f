#include "validate/results/certificate.h"

#include "scenes/frame/header_words.h"
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

const std::vector<CertificateFigure>& certificateFigures() {
    static const std::vector<CertificateFigure> figures{
        {"error_px_p50", &CertificateSummary::pxP50},
        {"error_px_p99", &CertificateSummary::pxP99},
        {"error_px_max", &CertificateSummary::pxMax},
        {"error_px_aim", &CertificateSummary::pxAim},
        {"error_world_p50", &CertificateSummary::worldP50},
        {"error_world_p99", &CertificateSummary::worldP99},
        {"error_world_max", &CertificateSummary::worldMax},
    };
    return figures;
}

void setAbsent(CertificateSummary& certificate, const std::string& reason) {
    for (const CertificateFigure& entry : certificateFigures())
        certificate.*entry.figure = Figure::absent(reason);
    certificate.limit.reset();
    certificate.limitReason = reason;
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

CertificateSummary certificateFromHeader(const Frame& frame, const std::string& where) {
    const std::string prefix = "certificate.";
    CertificateSummary certificate;
    for (const CertificateFigure& entry : certificateFigures()) {
        const std::string key = prefix + entry.key;
        const auto found = frame.metadata.find(key);
        if (found == frame.metadata.end()) {
            certificate.*entry.figure =
                Figure::absent(fmt::format("the reference's file has no header field {}", key));
            continue;
        }
        HeaderWords words(found->second);
        const double value = words.number();
        if (!words.ok() || value < 0) refuseHeaderField(where, key, found->second, "a number >= 0");
        certificate.*entry.figure = value;
    }
    const std::string limitKey = prefix + "error_limit";
    if (const auto found = frame.metadata.find(limitKey); found != frame.metadata.end())
        certificate.limit = found->second;
    else
        certificate.limitReason = fmt::format("the reference's file has no header field {}", limitKey);
    countPixels(frame, certificate);
    return certificate;
}

std::string certificateLine(const CertificateSummary& certificate, const std::string& of) {
    const CertificateSummary& c = certificate;
    std::string line = fmt::format("certificate{}: ", of);
    if (!c.pxP99)
        line += fmt::format("none: {}", c.pxP99.reason());
    else {
        const auto px = [](const Figure& figure) {
            return figure ? fmt::format("{:.3g} px", *figure) : std::string("unknown");
        };
        line += fmt::format("error p50 {}, p99 {}, max {} (aim {} at p99)", px(c.pxP50), px(c.pxP99),
                            px(c.pxMax), px(c.pxAim));
        if (c.worldP99) line += fmt::format("; world p99 {:.2g}", *c.worldP99);
    }
    if (c.uncertainPixels) {
        line += fmt::format("; uncertain {} pixels ({} covered)", shownCount(c.uncertainPixels),
                            shownCount(c.coveredPixels));
        if (!c.uncertainShadowPixels.empty()) line += ", shadow" + shadowCounts(c);
    }
    if (c.limit && !c.limit->empty()) line += fmt::format("; the aim isn't met: {}", *c.limit);
    return line;
}

std::vector<std::string> certificateSentences(const CertificateSummary& certificate) {
    const CertificateSummary& c = certificate;
    std::vector<std::string> sentences;
    if (!c.pxP99)
        sentences.push_back(fmt::format(
            "How far the reference itself is from the true surface isn't known: {}.", c.pxP99.reason()));
    else if (c.pxP50 && c.pxMax && c.pxAim)
        sentences.push_back(
            fmt::format("The reference's own error, measured in the pixels that show the surface: half of "
                        "them are within "
                        "{:.3g} px of it, 99 % within {:.3g} px (the aim: {:.3g} px), all within {:.3g} px.",
                        *c.pxP50, *c.pxP99, *c.pxAim, *c.pxMax));
    else
        sentences.push_back(fmt::format(
            "The reference's own error: 99 % of the pixels that show the surface are within {:.3g} px of it.",
            *c.pxP99));
    if (c.worldP50 && c.worldP99 && c.worldMax)
        sentences.push_back(
            fmt::format("In world units: {:.2g}, {:.2g} and {:.2g}.", *c.worldP50, *c.worldP99, *c.worldMax));
    if (c.limit && !c.limit->empty()) sentences.push_back(fmt::format("The aim isn't met: {}.", *c.limit));
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
