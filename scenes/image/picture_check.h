// Is a PNG or JPEG file whole? libjpeg fills what a truncated file lacks with gray and calls that a warning;
// libpng prints lines of its own to stderr. So damage is looked for before either is asked.
#pragma once

#include <filesystem>

namespace plumbline {

/// Throws InputError for a PNG whose chunks don't reach its end or don't fit their checksums, and for a JPEG
/// without its end-of-image marker. Does nothing with other files.
void checkPictureIsWhole(const std::filesystem::path& file);

} // namespace plumbline
