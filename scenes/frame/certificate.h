// What a reference says of its own error, and the header fields that hold it.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace plumbline {

/// How far the traced micro-triangles are from the surface P(u,v) they stand for, measured.
///
/// Each pixel that shows the surface has the bound of the grid of 16 x 16 micro-cells it sees
/// (MicroGrid::errorWorld): no place of the surface is farther from the one of the same (u,v) on the
/// micro-triangles. The relief's part of it comes from the texels themselves (points inside, edges, creases),
/// the base's from samples, with a margin. Percentiles are nearest-rank over those pixels; 0 without any.
///
/// nullopt: not known. A reference measures all of it; a header may have only some.
struct Certificate {
    using Number = std::optional<double>;
    Number pxP50, pxP99, pxMax;          // pixels: seen from the camera, as if across the line of sight
    Number pxAim;                        // what pxP99 was to be
    Number worldP50, worldP99, worldMax; // world units
    std::optional<std::string> limit;    // why pxP99 is above the aim ("--memory 256 MB"); empty if it isn't

    bool operator==(const Certificate&) const = default;
};

/// A row of the table of its numbers.
struct CertificateRow {
    std::string_view key; // in results.json, and in a header behind "certificate."
    std::string_view unit;
    std::string_view meaning;
    Certificate::Number Certificate::*number;
};

/// Every number, in the order of results.json.
std::span<const CertificateRow> certificateTable();

/// The key of the text, Certificate::limit.
inline constexpr std::string_view kCertificateLimitKey = "error_limit";

/// Adds what is known to a header, as fields "certificate.<key>".
void writeCertificate(const Certificate& certificate, std::map<std::string, std::string>& metadata);

/// What a header says, whoever wrote it. Throws InputError, with `where` in front, for a field that isn't a
/// number >= 0.
Certificate readCertificate(const std::map<std::string, std::string>& metadata, const std::string& where);

} // namespace plumbline
