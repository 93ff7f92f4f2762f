// What a reference says of its own error, as results hold it: measured by the reference that drew the frame,
// or read from the header of its file; and that in words.
//
// The error is the distance of the micro-triangles that pixels see from the true surface P(u,v); percentiles
// are over the pixels that show the surface.
#pragma once

#include "scenes/frame/frame.h"
#include "validate/metrics/figure.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plumbline {

struct CertificateSummary {
    Figure pxP50, pxP99, pxMax, pxAim;   // pixels; pxAim: what pxP99 was to be
    Figure worldP50, worldP99, worldMax; // world units
    std::optional<std::string> limit;    // why pxP99 is above the aim, "" if it isn't; nullopt: not known
    std::string limitReason;             // why that isn't known

    Figure coveredPixels;                                // of the reference's frame
    Figure uncertainPixels;                              // its channel `uncertain`
    std::map<std::string, Figure> uncertainShadowPixels; // by light
};

/// The figures that are numbers, under their keys in results.json ("reference") and, behind "certificate.",
/// in a frame's header. The text `limit` has the key "error_limit".
struct CertificateFigure {
    const char* key;
    Figure CertificateSummary::*figure;
};
const std::vector<CertificateFigure>& certificateFigures();

/// No figure is known; the counts of pixels are left as they are.
void setAbsent(CertificateSummary& certificate, const std::string& reason);

/// Counts the frame's pixels. Where none is covered there is nothing whose error was measured: the figures
/// become absent.
void countPixels(const Frame& reference, CertificateSummary& certificate);

/// What a reference's frame says of its own error: the header fields certificate.error_px_p99 and its like,
/// numbers >= 0, and the counts of its channels. What isn't there is absent. Throws InputError, with `where`
/// in front, for a field that can't be read.
CertificateSummary certificateFromHeader(const Frame& frame, const std::string& where);

/// One line without its end: "certificate: error p50 0.004 px, p99 0.03 px, …". `of`: "" or which reference,
/// as " (proxy)".
std::string certificateLine(const CertificateSummary& certificate, const std::string& of = "");

/// The same for a page, a sentence each.
std::vector<std::string> certificateSentences(const CertificateSummary& certificate);

} // namespace plumbline
