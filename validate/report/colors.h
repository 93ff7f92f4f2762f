// The colors of frames and their differences: a palette for classes of pixels and color maps for values.
// 8-bit sRGB codes.
//
// These are the only tables. pictures.cpp writes PNG images with them; report_data.cpp passes them to the
// page, whose page/src/viewer/colors.ts computes the same sRGB codes.
//
// The colors can be distinguished with any common color blindness (palette: Okabe and Ito 2008, "Color
// universal design").
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline {

using Rgb = std::array<uint8_t, 3>;

/// Classes of pixels.
namespace palette {
inline constexpr Rgb kNothing{24, 26, 30};            // neither frame shows anything
inline constexpr Rgb kAgree{190, 190, 190};           // light gray
inline constexpr Rgb kMissing{230, 159, 0};           // orange: only the reference shows it; falsely lit
inline constexpr Rgb kExtra{0, 114, 178};             // blue: only the test shows it; falsely in shadow
inline constexpr Rgb kOther{204, 121, 167};           // reddish purple: the test shows another object
inline constexpr Rgb kBothDark{90, 90, 90};           // in shadow in both
inline constexpr Rgb kInvalid{240, 228, 66};          // yellow: a value that isn't a finite number
inline constexpr Rgb kUnshared{60, 64, 72};           // not the same object in both
inline constexpr Rgb kUncertainAgrees{150, 205, 188}; // pale green: agrees, the reference is uncertain
inline constexpr Rgb kUncertainDiffers{0, 158, 115};  // bluish green: differs, the reference is uncertain

/// The colors above, with their names in templates and in the data of the page.
std::vector<std::pair<std::string, Rgb>> all();
} // namespace palette

/// Maps values to colors by linear interpolation in sRGB codes between equidistant stops.
struct ColorMap {
    std::string_view name; // in templates and in the data of the page
    /// x of the first stop: 0, or -1 for a map that diverges from its middle stop. x of the last one is 1.
    double low;
    std::span<const Rgb> stops;
};

namespace colormap {
/// Signed errors: blue = too near, white = 0, orange = too far.
extern const ColorMap kDiverging;
/// Magnitudes and counts: pale yellow = 0, dark brown = the largest.
extern const ColorMap kSequential;
/// Depths: light = near.
extern const ColorMap kGray;
/// Curvatures: blue = concave, green = flat, red = convex, as in Watt and Policarpo (2005), Fig. 5.28.
extern const ColorMap kCurvature;

std::vector<ColorMap> all();
} // namespace colormap

/// `x` is clamped to the ends of the map.
Rgb colorAt(const ColorMap& map, double x);

/// "#e69f00".
std::string cssColor(const Rgb& color);

} // namespace plumbline
