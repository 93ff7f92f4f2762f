// The colors of frames and their differences: what a pixel is, and how a value is colored. 8-bit sRGB
// codes.
//
// These are the only tables. pictures.cpp paints PNG pictures from them; report_data.cpp hands them to the
// page, whose page/src/viewer/colors.ts paints its canvases from them code for code.
//
// Colors are told apart with any common color blindness (palette: Okabe and Ito 2008, "Color universal
// design").
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

/// What a pixel is.
namespace palette {
inline constexpr Rgb kNothing{24, 26, 30};   // neither frame shows anything
inline constexpr Rgb kAgree{190, 190, 190};  // light gray
inline constexpr Rgb kMissing{230, 159, 0};  // orange: should be there and isn't; lit and should be dark
inline constexpr Rgb kExtra{0, 114, 178};    // blue: is there and shouldn't be; dark and should be lit
inline constexpr Rgb kOther{204, 121, 167};  // reddish purple: another object in front
inline constexpr Rgb kBothDark{90, 90, 90};  // in shadow in both
inline constexpr Rgb kInvalid{240, 228, 66}; // yellow: a value that isn't a finite number
inline constexpr Rgb kUnshared{60, 64, 72};  // not the same object in both
inline constexpr Rgb kUncertainAgrees{150, 205, 188}; // pale green: agrees, the reference is uncertain
inline constexpr Rgb kUncertainDiffers{0, 158, 115};  // bluish green: differs, the reference is uncertain

/// Those above, by their names in templates and in the page's data.
std::vector<std::pair<std::string, Rgb>> all();
} // namespace palette

/// How a value becomes a color: on straight lines in sRGB codes between stops equally far apart.
struct ColorMap {
    std::string_view name; // in templates and in the page's data
    /// x of the first stop: 0, or -1 where the map diverges from its middle stop. x of the last one is 1.
    double low;
    std::span<const Rgb> stops;
};

namespace colormap {
/// Signed errors: blue = too near, white = 0, orange = too far.
extern const ColorMap kDiverging;
/// Sizes and counts: pale yellow = 0, dark brown = the most.
extern const ColorMap kSequential;
/// Depths: light = near.
extern const ColorMap kGray;
/// Curvatures: blue = concave, green = level, red = convex, as in Watt and Policarpo (2005), Fig. 5.28.
extern const ColorMap kCurvature;

std::vector<ColorMap> all();
} // namespace colormap

/// `x` is clamped to the map's ends.
Rgb colorAt(const ColorMap& map, double x);

/// "#e69f00".
std::string cssColor(const Rgb& color);

} // namespace plumbline
