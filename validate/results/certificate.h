// What a reference says of its own error, as results hold it: the certificate, measured by the reference that
// drew the frame or read from the header of its file, with the reasons for what it lacks and with counts of
// the frame's pixels; and that in words.
//
// The error is the distance of the micro-triangles that pixels see from the true surface P(u,v); percentiles
// are over the pixels that show the surface.
#pragma once

#include "scenes/frame/certificate.h"
#include "scenes/frame/frame.h"
#include "validate/metrics/figure.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

struct CertificateSummary {
    Certificate error;
    std::string unknownReason; // of what `error` lacks; empty: the header of its file has no such field

    Figure coveredPixels;                                // of the reference's frame
    Figure uncertainPixels;                              // its channel `uncertain`
    std::map<std::string, Figure> uncertainShadowPixels; // by light

    /// A number of the error.
    Figure figure(const CertificateRow& row) const;
    Figure figure(Certificate::Number Certificate::*number) const;
    /// Why the error lacks what has that key.
    std::string reasonWithout(std::string_view key) const;
};

/// Of a reference that was just drawn.
CertificateSummary summaryOf(const Certificate& measured, const Frame& reference);

/// Of the frame of a file: readCertificate() of its header, and the counts of its channels. Throws as
/// readCertificate().
CertificateSummary certificateFromHeader(const Frame& reference, const std::string& where);

/// Nothing of the error is known; the counts of pixels are left as they are.
void setAbsent(CertificateSummary& certificate, const std::string& reason);

/// Counts the frame's pixels. Where none is covered there is nothing whose error was measured: it becomes
/// absent.
void countPixels(const Frame& reference, CertificateSummary& certificate);

/// One line without its end: "certificate: error p50 0.004 px, p99 0.03 px, …". `of`: "" or which reference,
/// as " (proxy)".
std::string certificateLine(const CertificateSummary& certificate, const std::string& of = "");

/// The same for a page, a sentence each.
std::vector<std::string> certificateSentences(const CertificateSummary& certificate);

} // namespace plumbline
