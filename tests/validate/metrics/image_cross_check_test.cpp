// Compares image figures with those of OpenImageIO's ImageBufAlgo::compare.
#include "tests/validate/metrics/painted_frames.h"
#include "validate/metrics/image_error.h"
#include "validate/report/pictures.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumbline {
namespace {

using namespace test;

/// Various colors: smooth, noisy, brighter than white.
Frame picture(unsigned seed, float noise) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-noise, noise);
    Frame frame = emptyFrame(64, 48);
    for (const char* color : {"R", "G", "B"}) {
        const auto plane = frame.channel(color);
        for (size_t i = 0; i < plane.size(); ++i)
            plane[i] = 0.6f + 0.5f * std::sin(static_cast<float>(i) * 0.01f) + uniform(random);
    }
    return frame;
}

/// The image of the report as 8-bit codes.
OIIO::ImageBuf codesOf(const Frame& frame) {
    const Picture shown = colorPicture(frame);
    OIIO::ImageBuf buffer(OIIO::ImageSpec(frame.width(), frame.height(), 3, OIIO::TypeDesc::UINT8));
    buffer.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::UINT8, shown.rgb.data());
    return buffer;
}

TEST(ImageErrorCrossCheck, RmseAndPsnr_EqualOpenImageIO) {
    for (const auto& [seed, noise] : {std::pair(1u, 0.001f), {2u, 0.02f}, {3u, 0.6f}}) {
        const Frame reference = picture(1, 0), test = picture(seed, noise);
        const ImageError ours = computeImageError(FramePair(reference, test, {}));
        const auto theirs = OIIO::ImageBufAlgo::compare(codesOf(reference), codesOf(test), 0.5f, 0.5f);
        // It converts codes to float and sums squared differences: codes of about 1 have a relative error of
        // 2^-24, differences are at least 1/255.
        EXPECT_NEAR(*ours.rmse, theirs.rms_error, 1e-4 * theirs.rms_error) << noise;
        EXPECT_NEAR(*ours.psnrDb, theirs.PSNR, 1e-3) << noise;
        EXPECT_GT(*ours.rmse, 0);
    }
}

} // namespace
} // namespace plumbline
