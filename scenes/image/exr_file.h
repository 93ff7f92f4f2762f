// Reads and writes OpenEXR files as named planes of floats. Frames (frame_exr.h) and images (image_file.h) go
// through this file, the only one that uses the OpenEXR library. Row 0 = top row; no color conversion.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

struct ExrPlanes {
    int width = 0, height = 0;
    std::map<std::string, std::vector<float>> planes; // width x height each; half and uint become float
    std::map<std::string, std::string> attributes;    // string attributes except OpenEXR's own
};

/// Selects the channels to read from the names of a file's channels; may throw to reject the file.
using ExrSelection = std::function<std::vector<std::string>(const std::vector<std::string>& channelNames)>;

/// Reads scan-line and tiled files (the finest level of mipmaps and ripmaps) with one part or several parts
/// of equal size. A channel whose name also occurs in an earlier part is called "PART.CHANNEL". The data
/// window may have any origin but must equal the display window, because a cropped image has undefined
/// pixels. Throws InputError if the file is missing, not an EXR, truncated, damaged, deep, an environment map
/// or a stereo image, if its parts differ in size, if a selected channel is subsampled, or if it exceeds 1
/// Gpixel. Sizes are checked before memory is allocated.
ExrPlanes readExr(const std::filesystem::path& file, const ExrSelection& select);

/// 32-bit float, ZIP, scan lines, no date: equal planes and attributes give equal bytes, whatever the number
/// of threads. The file is replaced atomically. Each plane: width x height. Throws InputError if the file
/// can't be written or an attribute name is reserved by OpenEXR.
void writeExr(const std::filesystem::path& file, int width, int height,
              const std::map<std::string, std::span<const float>>& planes,
              const std::map<std::string, std::string>& attributes);

} // namespace plumbline
