#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/image_error.h"
#include "validate/report/pictures.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// The linear value of an sRGB code (IEC 61966-2-1, the inverse).
float linearOf(int code) {
    const double encoded = code / 255.0;
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

void paintCodes(Frame& frame, int x, int y, int r, int g, int b) {
    set(frame, "R", x, y, linearOf(r));
    set(frame, "G", x, y, linearOf(g));
    set(frame, "B", x, y, linearOf(b));
}

ImageError errorOf(const Frame& reference, const Frame& test) {
    return computeImageError(FramePair(reference, test, {}));
}

TEST(ImageError, EqualImages_HaveNoPsnr) {
    Frame frame = emptyFrame(4, 3);
    paintCodes(frame, 1, 1, 100, 150, 200);
    const ImageError result = errorOf(frame, frame);
    EXPECT_EQ(result.domainPx, 12u);
    EXPECT_EQ(*result.rmse, 0);
    EXPECT_EQ(*result.badpix2Codes, 0);
    EXPECT_FALSE(result.psnrDb);
    EXPECT_EQ(result.psnrDb.reason(), "the images are equal");
}

// Four pixels, twelve codes: one pixel differs by 3, 4 and 0, another by 0, 0 and 12. Squares: 9 + 16 + 144 =
// 169; RMSE = sqrt(169 / 12) / 255.
TEST(ImageError, KnownCodes_EqualHandComputed) {
    Frame reference = emptyFrame(2, 2), test = emptyFrame(2, 2);
    paintCodes(reference, 0, 0, 100, 150, 200);
    paintCodes(test, 0, 0, 103, 146, 200);
    paintCodes(reference, 1, 1, 10, 20, 30);
    paintCodes(test, 1, 1, 10, 20, 18);
    const ImageError result = errorOf(reference, test);
    const double rmse = std::sqrt(169.0 / 12.0) / 255.0;
    EXPECT_DOUBLE_EQ(*result.rmse, rmse);
    EXPECT_DOUBLE_EQ(*result.psnrDb, 20 * std::log10(1 / rmse));
    EXPECT_EQ(result.bad2CodesPx, 2u);
    EXPECT_EQ(*result.badpix2Codes, 0.5);
}

// Every code differs by 255: RMSE 1, 0 dB. One pixel of 100 differs by 255: RMSE sqrt(1 / 100) = 0.1, which
// is 20 dB.
TEST(ImageError, BlackAndWhite_IsZeroDecibels) {
    Frame black = emptyFrame(10, 10), white = emptyFrame(10, 10), dot = emptyFrame(10, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            paintCodes(white, x, y, 255, 255, 255);
    paintCodes(dot, 4, 7, 255, 255, 255);
    EXPECT_EQ(*errorOf(black, white).rmse, 1);
    EXPECT_EQ(*errorOf(black, white).psnrDb, 0);
    EXPECT_FALSE(std::signbit(*errorOf(black, white).psnrDb)); // -0 would be written to files
    EXPECT_EQ(*errorOf(black, white).badpix2Codes, 1);
    EXPECT_NEAR(*errorOf(black, dot).psnrDb, 20, 1e-12); // neither 0.1 nor its logarithm is exact
    EXPECT_EQ(*errorOf(black, dot).badpix2Codes, 0.01);
}

// A pixel counts once for any number of different channels, and not for a difference of two codes.
TEST(ImageError, TwoCodes_AreNotCounted) {
    Frame reference = emptyFrame(4, 1), test = emptyFrame(4, 1);
    for (int x = 0; x < 4; ++x)
        paintCodes(reference, x, 0, 100, 100, 100);
    paintCodes(test, 0, 0, 102, 98, 102);
    paintCodes(test, 1, 0, 100, 100, 103);
    paintCodes(test, 2, 0, 97, 100, 100);
    paintCodes(test, 3, 0, 90, 110, 120);
    EXPECT_EQ(errorOf(reference, test).bad2CodesPx, 3u);
}

// 1 and 7 are both white, -1 and 0 both black, because colors are clamped as in a PNG.
TEST(ImageError, OutOfRangeColors_AreClamped) {
    Frame reference = emptyFrame(2, 1), test = emptyFrame(2, 1);
    set(reference, "R", 0, 0, 1);
    set(test, "R", 0, 0, 7);
    set(test, "G", 1, 0, -1);
    EXPECT_EQ(*errorOf(reference, test).rmse, 0);
    EXPECT_EQ(errorOf(reference, test).psnrDb.reason(), "the images are equal");
}

TEST(ImageError, NanColors_AreCountedSeparately) {
    Frame reference = emptyFrame(3, 1), test = emptyFrame(3, 1);
    set(reference, "R", 0, 0, kNanF);
    set(test, "B", 1, 0, kInfinityF);
    paintCodes(test, 2, 0, 255, 255, 255);
    const ImageError result = errorOf(reference, test);
    EXPECT_EQ(result.domainPx, 1u);
    EXPECT_EQ(result.invalidPx, 2u);
    EXPECT_EQ(*result.rmse, 1);
    set(test, "G", 2, 0, kNanF);
    EXPECT_THAT(errorOf(reference, test).rmse.reason(), HasSubstr("no pixel has a finite color"));
    EXPECT_EQ(errorOf(reference, test).invalidPx, 3u);
}

TEST(ImageError, NoColor_IsAbsentWithReason) {
    const Frame frame = emptyFrame(2, 1);
    Frame gray(2, 1);
    gray.add("A");
    gray.add("R");
    gray.add("G");
    const ImageError result = errorOf(frame, gray);
    for (const Figure& figure : {result.psnrDb, result.rmse, result.badpix2Codes})
        EXPECT_THAT(figure.reason(), HasSubstr("the test frame has no channel B"));
}

/// Frames of various colors: dark, bright, brighter than white.
Frame randomPicture() {
    Frame frame = emptyFrame(5, 4);
    for (const char* color : {"R", "G", "B"})
        for (float& value : frame.channel(color))
            value = static_cast<float>(*rc::gen::inRange(-100, 1200)) / 1000.0f;
    return frame;
}

RC_GTEST_PROP(ImageErrorProperty, RandomFrames_EqualReportsImages, ()) {
    const Frame a = randomPicture(), b = randomPicture();
    const Picture shownA = colorPicture(a), shownB = colorPicture(b);
    double sum = 0;
    for (size_t i = 0; i < shownA.rgb.size(); ++i)
        sum += std::pow((shownA.rgb[i] - shownB.rgb[i]) / 255.0, 2);
    // Sums of 60 terms in another order have rounding errors in the 15th digit.
    RC_ASSERT(std::abs(*errorOf(a, b).rmse - std::sqrt(sum / static_cast<double>(shownA.rgb.size()))) <
              1e-12);
}

RC_GTEST_PROP(ImageErrorProperty, SwappedOrFlipped_IsEqual, ()) {
    const Frame a = randomPicture(), b = randomPicture();
    const ImageError result = errorOf(a, b);
    for (const ImageError& other : {errorOf(b, a), errorOf(flippedHorizontally(a), flippedHorizontally(b)),
                                    errorOf(flippedVertically(a), flippedVertically(b))}) {
        RC_ASSERT(other.rmse == result.rmse);
        RC_ASSERT(other.psnrDb == result.psnrDb);
        RC_ASSERT(other.bad2CodesPx == result.bad2CodesPx);
    }
}

} // namespace
} // namespace plumbline
