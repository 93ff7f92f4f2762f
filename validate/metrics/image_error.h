// Image error: the difference of the two frames' colors, as the report's PNGs show them.
//
// Domain: every pixel of the image, background included, whose R G B are finite in both frames. With c the
// 8-bit sRGB code of a channel (scenes/core/srgb.h: colors are clamped to [0, 1]):
//     RMSE = sqrt(mean over pixels and channels of ((c_test - c_reference) / 255)^2)
//     PSNR = 20 log10(1 / RMSE)                           in dB
//     badpix_2codes = share of the pixels of which a channel differs by more than 2 codes
// Rounding and the last bits of a shader change equal shading by one or two codes, not by more.
//
// There is no perceptual figure: OpenImageIO, which is linked anyway, has compare_Yee, but in 2.4 that finds
// no difference between white and black and takes 1.6 s at 800 x 600. There is no interval. The background
// counts, so figures of images with different shares of background aren't comparable.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct ImageError {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0; // a color is NaN or infinite: not in the domain
    Figure psnrDb;          // absent if no code differs
    Figure rmse;            // in [0, 1]
    Figure badpix2Codes;    // in [0, 1]
    uint64_t bad2CodesPx = 0;
};

/// Absent if a frame lacks R, G or B.
ImageError computeImageError(const FramePair& pair);

Metric imageErrorMetric();

} // namespace plumbline
