// OpenEXR files as named planes of float: the one place that talks to the OpenEXR library. Frames
// (frame_exr.h) are written and pictures (image_file.h) read through it. Row 0 = top row; no color
// conversion.
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
    std::map<std::string, std::vector<float>> planes; // width x height each; half and uint became float
    std::map<std::string, std::string> attributes;    // those of type string, without OpenEXR's own
};

/// Chooses among the names of a file's channels those to read; it may throw to refuse the file.
using ExrSelection = std::function<std::vector<std::string>(const std::vector<std::string>& channelNames)>;

/// Scan-line or tiled (of mipmaps and ripmaps the finest level), in one part or in several of one size. A
/// channel that an earlier part has too is called "PART.CHANNEL". The data window may begin anywhere but must
/// be the display window: a crop leaves pixels nobody knows anything about. Throws InputError for a file that
/// is missing, not an EXR, truncated, damaged, deep, an environment map, a stereo picture, of parts of
/// several sizes, with a subsampled channel among those chosen, or larger than 1 Gpixel; sizes are checked
/// before any memory is taken.
ExrPlanes readExr(const std::filesystem::path& file, const ExrSelection& select);

/// 32-bit float, ZIP, scan lines, no date: equal planes and attributes give equal bytes, whatever the number
/// of threads. Write-then-rename. Each plane: width x height. Throws InputError if the place can't be
/// written, or an attribute has a name that OpenEXR reserves.
void writeExr(const std::filesystem::path& file, int width, int height,
              const std::map<std::string, std::span<const float>>& planes,
              const std::map<std::string, std::string>& attributes);

} // namespace plumbline
