// Pictures: the difference of the two frames' colors, as the report's PNGs show them.
//
// Domain: every pixel of the picture, whatever it shows, whose R G B are finite in both frames. With c the
// 8-bit sRGB code of a channel (scenes/core/srgb.h: colors below 0 and above 1 count as 0 and 1):
//     RMSE = sqrt(mean over pixels and channels of ((c_test - c_reference) / 255)^2)
//     PSNR = 20 log10(1 / RMSE)                           in dB
//     badpix_2codes = share of the pixels a channel of which differs by more than 2 codes
// One or two codes are what rounding and the last bits of a shader make of equal shading; more is a
// difference.
//
// There is no perceptual figure: the library at hand has one, OpenImageIO's compare_Yee, but as of 2.4 it
// doesn't see luminance (white against black: no pixel differs) and takes 1.6 s at 800 x 600. There is no
// interval; the background counts, so that figures of pictures with different shares of it don't compare.
#pragma once

#include "validate/metrics/metric.h"

namespace plumbline {

struct ImageError {
    uint64_t domainPx = 0;
    uint64_t invalidPx = 0; // a color is NaN or infinite: not in the domain
    Figure psnrDb;          // absent where no code differs
    Figure rmse;            // in [0, 1]
    Figure badpix2Codes;    // in [0, 1]
    uint64_t bad2CodesPx = 0;
};

/// Absent if a frame lacks R, G or B.
ImageError computeImageError(const FramePair& pair);

Metric imageErrorMetric();

} // namespace plumbline
