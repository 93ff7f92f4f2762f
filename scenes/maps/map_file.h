// Reads height maps and color maps from images (image_file.h reads the pixels).
#pragma once

#include "scenes/maps/color_map.h"
#include "scenes/maps/height_map.h"

#include <filesystem>

namespace plumbline {

/// The meaning of an image's values: depth d, or height h = 1 - d.
enum class Stores { Depth, Height };

/// Integers become v / 255 or v / 65535; floats are used unchanged. There is no color conversion, whatever
/// color space the file declares. A color image must be gray: a texel's R, G and B may differ by 8/255 for
/// integers, because of JPEG and palette noise, and by 1e-4 for floats. Its red channel is used, as in
/// shaders. Alpha is ignored. Throws InputError if readImage fails, if the image isn't gray, or if values are
/// NaN or outside [0,1]; the message gives their number and the position of the first one (column, row from
/// the top).
HeightMap readHeightMap(const std::filesystem::path& file, Stores stores, Wrap wrapS = Wrap::Repeat,
                        Wrap wrapT = Wrap::Repeat);

/// 8-bit and 16-bit integers are decoded from sRGB (IEC 61966-2-1) to linear; floats are already linear. A
/// gray image gives three equal channels; alpha is ignored. Throws InputError if readImage fails or a value
/// is negative or not finite.
ColorMap readColorMap(const std::filesystem::path& file);

} // namespace plumbline
