// Frames as OpenEXR scan-line files, 32-bit float, ZIP; equal frames give equal bytes (no date is stored).
#pragma once

#include "frame.h"

#include <filesystem>

namespace plumbline {

/// Writes to a temporary name in the same folder, then renames. Throws InputError if the place can't be written.
void writeFrame(const Frame& frame, const std::filesystem::path& file);

/// Reads any scan-line or tiled, single-part EXR: half, float and uint channels become float. Throws InputError for a
/// file that is missing, truncated, not an EXR, deep, multi-part or larger than 1 Gpixel.
Frame readFrame(const std::filesystem::path& file);

} // namespace plumbline
