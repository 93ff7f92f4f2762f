#include "scenes/core/error.h"
#include "scenes/frame/certificate.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using Metadata = std::map<std::string, std::string>;

TEST(CertificateHeader, EveryNumber_RoundTrips) {
    Certificate written;
    double number = 1.0 / 3.0;
    for (const CertificateRow& row : certificateTable()) {
        written.*row.number = number;
        number /= 7;
    }
    written.limit = "--memory 256 MB";
    Metadata metadata;
    writeCertificate(written, metadata);
    EXPECT_EQ(metadata.size(), certificateTable().size() + 1);  // no two rows have one key
    EXPECT_TRUE(readCertificate(metadata, "a.exr") == written); // bit for bit
}

TEST(CertificateHeader, Fields_HaveTheseNames) {
    const Metadata metadata{
        {"certificate.error_px_p50", "0.004"},   {"certificate.error_px_p99", "3.1e-2"},
        {"certificate.error_px_max", "0.4"},     {"certificate.error_px_aim", "0.05"},
        {"certificate.error_world_p50", "1e-6"}, {"certificate.error_world_p99", "1.2e-05"},
        {"certificate.error_world_max", "0"},    {"certificate.error_limit", ""}};
    const Certificate certificate = readCertificate(metadata, "a.exr");
    EXPECT_EQ(certificate.pxP50, 0.004);
    EXPECT_EQ(certificate.pxP99, 0.031);
    EXPECT_EQ(certificate.pxMax, 0.4);
    EXPECT_EQ(certificate.pxAim, 0.05);
    EXPECT_EQ(certificate.worldP50, 1e-6);
    EXPECT_EQ(certificate.worldP99, 1.2e-5);
    EXPECT_EQ(certificate.worldMax, 0);
    EXPECT_EQ(certificate.limit, "");
}

TEST(CertificateHeader, WhatIsUnknown_IsNotWritten) {
    Metadata metadata;
    writeCertificate({}, metadata);
    EXPECT_THAT(metadata, IsEmpty());
    EXPECT_TRUE(readCertificate(metadata, "a.exr") == Certificate{});
}

TEST(CertificateHeader, UnreadableNumber_IsRefusedByName) {
    for (const char* bad : {"-1", "nan", "inf", "", "0.1 0.2", "small"}) {
        try {
            (void)readCertificate({{"certificate.error_world_max", bad}}, "a.exr");
            ADD_FAILURE() << "accepted: " << bad;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("a.exr: header field 'certificate.error_world_max'"));
        }
    }
}

TEST(CertificateTable, EveryRow_SaysWhatItMeans) {
    for (const CertificateRow& row : certificateTable()) {
        EXPECT_THAT(row.unit, Not(IsEmpty())) << row.key;
        EXPECT_THAT(row.meaning, Not(IsEmpty())) << row.key;
    }
}

} // namespace
} // namespace plumbline
