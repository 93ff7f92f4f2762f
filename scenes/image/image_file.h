// Reads and writes image files. EXR is read with OpenEXR; PNG, JPEG, TIFF, HDR and other formats through
// OpenImageIO. OpenImageIO takes 0.2 s and 130 MB to load, so it is in a separate module, plumbline_images,
// which is loaded for the first such file from the program's folder or from ../lib/plumbline relative to it.
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
    std::vector<float> values; // integers are divided by their type's maximum; no other conversion
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

/// Loads the module and returns its file. Throws MachineError if the module or a library it needs is missing.
std::filesystem::path imageModuleFile();

} // namespace plumbline
