#include "tests/validate/results/sample_results.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Certificate, FullCertificate_GivesLine) {
    CertificateSummary certificate = sampleCertificate();
    EXPECT_EQ(
        certificateLine(certificate),
        "certificate: error p50 0.004 px, p99 0.031 px, max 0.4 px (aim 0.05 px at p99); world p99 1.2e-05; "
        "uncertain 134 pixels (215000 covered), shadow lamp 7, sun 420");
    certificate.error.limit = "--memory 256 MB";
    EXPECT_THAT(certificateLine(certificate, " (proxy)"),
                ::testing::AllOf(HasSubstr("certificate (proxy): error"),
                                 HasSubstr("; the aim isn't met: --memory 256 MB")));
}

TEST(Certificate, NoFigures_GiveLine) {
    CertificateSummary certificate = sampleCertificate();
    setAbsent(certificate, "the reference didn't measure it");
    EXPECT_EQ(certificateLine(certificate),
              "certificate: none: the reference didn't measure it; uncertain 134 pixels "
              "(215000 covered), shadow lamp 7, sun 420");
    certificate.uncertainPixels = Figure::absent("no channel");
    EXPECT_EQ(certificateLine(certificate), "certificate: none: the reference didn't measure it");
}

TEST(Certificate, FullCertificate_GivesSentences) {
    CertificateSummary certificate = sampleCertificate();
    EXPECT_THAT(
        certificateSentences(certificate),
        ElementsAre(
            "The reference's own error, measured in the pixels that show the surface: half of them are "
            "within 0.004 px of it, 99 % within 0.031 px (the aim: 0.05 px), all within 0.4 px.",
            "In world units: 1e-06, 1.2e-05 and 0.00025.",
            "That error could change which object is seen in 134 pixels (215000 are covered), and "
            "whether it is in shadow, by light: lamp 7, sun 420."));
    certificate.error.limit = "--memory 256 MB";
    EXPECT_THAT(certificateSentences(certificate), Contains("The aim isn't met: --memory 256 MB."));
    setAbsent(certificate, "it came from afar");
    certificate.uncertainPixels = Figure::absent("no channel");
    EXPECT_THAT(
        certificateSentences(certificate),
        ElementsAre("How far the reference itself is from the true surface isn't known: it came from afar.",
                    "In which pixels that could change what is seen isn't known: no channel."));
}

// 8 x 6 pixels, two objects of 12 pixels each; one pixel outside them and one shadow are uncertain.
TEST(Certificate, Frame_GivesPixelCounts) {
    CertificateSummary certificate;
    countPixels(sampleReference(), certificate);
    EXPECT_EQ(*certificate.coveredPixels, 24);
    EXPECT_EQ(*certificate.uncertainPixels, 1);
    EXPECT_EQ(*certificate.uncertainShadowPixels.at("sun"), 1);
}

TEST(Certificate, MissingChannels_GiveAbsentCounts) {
    Frame frame(2, 1);
    frame.add("A")[0] = 1;
    frame.add("shadow.sun");
    CertificateSummary certificate;
    countPixels(frame, certificate);
    EXPECT_EQ(*certificate.coveredPixels, 1);
    EXPECT_THAT(certificate.uncertainPixels.reason(), HasSubstr("no channel uncertain"));
    EXPECT_THAT(certificate.uncertainShadowPixels.at("sun").reason(), HasSubstr("uncertain.shadow.sun"));
}

TEST(Certificate, NothingCovered_IsAbsentNotZero) {
    CertificateSummary certificate = sampleCertificate();
    countPixels(emptyFrame(2, 2), certificate);
    for (const CertificateRow& row : certificateTable())
        EXPECT_EQ(certificate.figure(row).reason(), "no pixel shows the surface") << row.key;
    EXPECT_FALSE(certificate.error.limit);
}

TEST(Certificate, OfFile_IsThatOfHeader) {
    Frame frame = sampleReference();
    const Certificate written = sampleCertificate().error;
    writeCertificate(written, frame.metadata);
    const CertificateSummary certificate = certificateFromHeader(frame, "a.exr");
    EXPECT_TRUE(certificate.error == written);
    EXPECT_EQ(*certificate.figure(&Certificate::pxP99), 0.031);
    EXPECT_EQ(*certificate.uncertainPixels, 1);
}

TEST(Certificate, IncompleteHeader_NamesMissingField) {
    const CertificateSummary certificate = certificateFromHeader(sampleReference(), "a.exr");
    EXPECT_EQ(certificate.figure(&Certificate::pxP99).reason(),
              "the reference's file has no header field certificate.error_px_p99");
    EXPECT_FALSE(certificate.error.limit);
    EXPECT_EQ(certificate.reasonWithout(kCertificateLimitKey),
              "the reference's file has no header field certificate.error_limit");
}

TEST(Certificate, Unmeasured_HasReason) {
    const CertificateSummary certificate = summaryOf(Certificate{}, sampleReference());
    EXPECT_EQ(certificate.figure(&Certificate::worldMax).reason(), "the reference didn't measure it");
}

} // namespace
} // namespace plumbline
