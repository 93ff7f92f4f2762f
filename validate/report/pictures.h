// What a person looks at: frames and their differences as 8-bit RGB. Row 0 = top row, width x height x 3.
//
// Colours are told apart with any common colour blindness (palette: Okabe and Ito 2008, "Color universal
// design").
#pragma once

#include "validate/metrics/frame_pair.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

using Rgb = std::array<uint8_t, 3>;

struct Picture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;
};

/// Colours with a fixed meaning in the difference pictures, and what the report's legends say of them.
namespace palette {
inline constexpr Rgb kNothing{24, 26, 30};   // neither frame shows anything
inline constexpr Rgb kAgree{190, 190, 190};  // light grey
inline constexpr Rgb kMissing{230, 159, 0};  // orange: should be there and isn't; lit and should be dark
inline constexpr Rgb kExtra{0, 114, 178};    // blue: is there and shouldn't be; dark and should be lit
inline constexpr Rgb kOther{204, 121, 167};  // reddish purple: another object in front
inline constexpr Rgb kBothDark{90, 90, 90};  // in shadow in both
inline constexpr Rgb kInvalid{240, 228, 66}; // yellow: a value that isn't a finite number
inline constexpr Rgb kUnshared{60, 64, 72};  // not the same object in both

/// Those above, by their names in templates and in the page's data.
inline std::vector<std::pair<std::string, Rgb>> all() {
    return {{"nothing", kNothing}, {"agree", kAgree},   {"missing", kMissing}, {"extra", kExtra},
            {"other", kOther},     {"dark", kBothDark}, {"invalid", kInvalid}, {"unshared", kUnshared}};
}
} // namespace palette

/// "#e69f00".
std::string cssColor(const Rgb& color);

/// Linear [0,1] to an 8-bit sRGB code (IEC 61966-2-1), clamped; NaN gives 0.
uint8_t srgbCode(double linear);

/// The frame's R G B, sRGB-encoded, pixels that aren't finite in kInvalid; grey coverage if the frame has no
/// colour.
Picture colorPicture(const Frame& frame);

/// Agree, missing, extra, another object.
Picture silhouettePicture(const FramePair& pair);

/// Signed error test - reference over shared pixels: blue = too near, orange = too far, white = 0, full
/// colour at +-range. `range` > 0, world units.
Picture depthErrorPicture(const FramePair& pair, std::span<const float> referenceDepth,
                          std::span<const float> testDepth, double range);

/// Colour of that map at x in [-1, 1], clamped.
Rgb divergingColor(double x);

/// cost.iterations over the test's covered pixels: pale = 0, dark = `most` and beyond; `most` > 0.
Picture iterationsPicture(const Frame& test, double most);

/// Colour of that map at x in [0, 1], clamped.
Rgb sequentialColor(double x);

/// A curvature channel over the test's covered pixels as in Watt and Policarpo (2005), chapter 5, Fig. 5.28:
/// red where the base is convex along the channel's direction, blue where it is concave, green where it is
/// level; full colour at +-range, world units^-1 > 0.
Picture curvaturePicture(const Frame& test, const std::string& channel, double range);

/// Colour of that map at x in [-1, 1], clamped.
Rgb curvatureColor(double x);

/// |value| of the channel that 90 % of the covered pixels stay within (edges and tips bend many times as
/// much); 0 if none is finite.
double curvatureRange(const Frame& test, const std::string& channel);

/// Both lit, both dark, false shadow (kExtra), false lit (kMissing) over shared pixels.
Picture shadowPicture(const FramePair& pair, const std::string& light);

} // namespace plumbline
