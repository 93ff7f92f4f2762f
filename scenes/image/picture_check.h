// Detects truncated or damaged PNG and JPEG files before they are decoded: libjpeg fills the missing part of
// a truncated file with gray and only warns, and libpng prints its own messages to stderr.
#pragma once

#include <filesystem>

namespace plumbline {

/// Throws InputError for a PNG file without its end chunk or with a wrong checksum, and for a JPEG file
/// without its end-of-image marker. Ignores other files.
void checkPictureIsWhole(const std::filesystem::path& file);

} // namespace plumbline
