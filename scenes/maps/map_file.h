// Height maps and color maps from pictures (image_file.h reads the pixels).
#pragma once

#include "scenes/maps/color_map.h"
#include "scenes/maps/height_map.h"

#include <filesystem>

namespace plumbline {

/// What a picture's values mean: depth d, or height h = 1 - d.
enum class Stores { Depth, Height };

/// Integers become v / 255 or v / 65535, floats are taken as they are; no color conversion whatever the file
/// says of its colors. A color picture must be gray (R, G and B of a texel at most 8/255 apart for
/// integers, where JPEG and palettes leave such noise, 1e-4 for floats); red is taken then, as shaders do.
/// Alpha is not looked at. Throws InputError for what readImage refuses, a picture that isn't gray, and
/// values that are NaN or outside [0,1], with their number and the first one's place (column, row from the
/// top).
HeightMap readHeightMap(const std::filesystem::path& file, Stores stores, Wrap wrapS = Wrap::Repeat,
                        Wrap wrapT = Wrap::Repeat);

/// 8 and 16-bit integers are decoded from sRGB (IEC 61966-2-1) to linear, floats are linear already. A gray
/// picture gives three equal channels; alpha is not looked at. Throws InputError also for values that are
/// negative or not finite.
ColorMap readColorMap(const std::filesystem::path& file);

} // namespace plumbline
