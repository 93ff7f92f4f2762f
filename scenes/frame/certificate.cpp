#include "scenes/frame/certificate.h"

#include "scenes/frame/header_fields.h"
#include "scenes/frame/header_words.h"

#include <fmt/format.h>

#include <array>

namespace plumbline {
namespace {

constexpr std::array<CertificateRow, 7> kRows{{
    {"error_px_p50", "pixels", "half of the pixels are within it", &Certificate::pxP50},
    {"error_px_p99", "pixels", "99 % of the pixels are within it", &Certificate::pxP99},
    {"error_px_max", "pixels", "all pixels are within it", &Certificate::pxMax},
    {"error_px_aim", "pixels", "what error_px_p99 was to be", &Certificate::pxAim},
    {"error_world_p50", "world units", "half of the pixels are within it", &Certificate::worldP50},
    {"error_world_p99", "world units", "99 % of the pixels are within it", &Certificate::worldP99},
    {"error_world_max", "world units", "all pixels are within it", &Certificate::worldMax},
}};

Certificate::Number readNumber(const std::string& field, const std::string& value, const std::string& where) {
    HeaderWords words(value);
    const double number = words.number();
    if (!words.ok() || number < 0) refuseHeaderField(where, field, value, "a number >= 0");
    return number;
}

} // namespace

std::span<const CertificateRow> certificateTable() {
    return kRows;
}

void writeCertificate(const Certificate& certificate, std::map<std::string, std::string>& metadata) {
    for (const CertificateRow& row : kRows)
        if (const Certificate::Number& number = certificate.*row.number)
            metadata[header::certificate(row.key)] = fmt::format("{}", *number);
    if (certificate.limit) metadata[header::certificate(kCertificateLimitKey)] = *certificate.limit;
}

Certificate readCertificate(const std::map<std::string, std::string>& metadata, const std::string& where) {
    Certificate certificate;
    for (const CertificateRow& row : kRows)
        if (const auto found = metadata.find(header::certificate(row.key)); found != metadata.end())
            certificate.*row.number = readNumber(found->first, found->second, where);
    if (const auto found = metadata.find(header::certificate(kCertificateLimitKey)); found != metadata.end())
        certificate.limit = found->second;
    return certificate;
}

} // namespace plumbline
