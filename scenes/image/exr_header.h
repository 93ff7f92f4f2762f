// A look at the header of an EXR file before the OpenEXR library, which takes memory for whatever the header
// claims, is let near it. Layout: OpenEXR documentation, "OpenEXR File Layout" (magic number, version field,
// attributes).
#pragma once

#include <filesystem>

namespace plumbline {

/// Throws InputError for a file that is missing, not an EXR, deep, cropped, larger than 1 Gpixel, an
/// environment map, a stereo picture, of parts of several sizes, with a header of more than 16 MB, or so
/// short that its claimed pixels can't be in it.
void checkExrHeader(const std::filesystem::path& file);

} // namespace plumbline
