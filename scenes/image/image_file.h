// Pictures in files. EXR is read with OpenEXR; PNG, JPEG, TIFF, HDR and the rest through OpenImageIO, which
// is loaded when the first such file is met (it takes 0.2 s and 130 MB), from the module plumbline_images
// beside the program, or in ../lib/plumbline from there.
#pragma once

#include "scenes/core/index.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace plumbline {

/// Row 0 = top row, as in the file; channels interleaved in the order R G B A (or Y, or Y A).
struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values; // integers divided by their type's largest value, nothing else done to them
    bool integer = false;      // stored as 8 or 16-bit integers

    size_t texelCount() const { return areaOf(width, height); }
    /// The channels of a texel; texels are numbered row by row.
    std::span<const float> texel(size_t number) const {
        return std::span(values).subspan(number * static_cast<size_t>(channels),
                                         static_cast<size_t>(channels));
    }
    float at(int x, int y, int channel) const { return item(texel(indexIn(width, x, y)), channel); }
};

/// Throws InputError: missing, not a picture, truncated, larger than 1 Gpixel. Alpha is returned as stored.
Image readImage(const std::filesystem::path& file);

/// 8-bit RGB PNG, row 0 = top, `rgb`: width x height x 3. Write-then-rename. Throws InputError if it can't be
/// written.
void writePng(const std::filesystem::path& file, int width, int height, const std::vector<uint8_t>& rgb);

/// The module that reads and writes them, loaded. Throws MachineError where it is missing or lacks a library.
std::filesystem::path imageModuleFile();

} // namespace plumbline
