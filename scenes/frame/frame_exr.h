// Frames as OpenEXR scan-line files, 32-bit float, ZIP; equal frames give equal bytes (no date is stored).
#pragma once

#include "scenes/frame/frame.h"

#include <filesystem>

namespace plumbline {

/// Writes to a temporary name in the same folder, then renames. Throws InputError if the place can't be
/// written.
void writeFrame(const Frame& frame, const std::filesystem::path& file);

} // namespace plumbline
