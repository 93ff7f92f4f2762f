// sRGB (IEC 61966-2-1): linear values in [0,1] and their encoding.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plumbline {

inline double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The 8-bit code of a linear value, clamped; NaN gives 0.
inline uint8_t srgbCode(double linear) {
    if (!(linear > 0)) return 0;
    const double clamped = std::min(linear, 1.0);
    const double encoded =
        clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1.0 / 2.4) - 0.055;
    return static_cast<uint8_t>(std::lround(255.0 * encoded));
}

} // namespace plumbline
