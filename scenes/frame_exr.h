// Frames as OpenEXR scan-line files, 32-bit float, ZIP; equal frames give equal bytes (no date is stored).
#pragma once

#include "frame.h"

#include <filesystem>

namespace plumbline {

/// Writes to a temporary name in the same folder, then renames. Throws InputError if the place can't be
/// written.
void writeFrame(const Frame& frame, const std::filesystem::path& file);

/// Reads any scan-line or tiled, single-part EXR: half, float and uint channels become float; channels the
/// table lacks are left out, string attributes become metadata. Throws InputError for a file that is missing,
/// truncated, not an EXR, deep, multi-part, cropped, without any channel of the table, or larger than 1
/// Gpixel.
Frame readFrame(const std::filesystem::path& file);

} // namespace plumbline
