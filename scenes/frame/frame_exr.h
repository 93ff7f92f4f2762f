// Frames as OpenEXR scan-line files, 32-bit float, ZIP; equal frames give equal bytes (no date is stored).
#pragma once

#include "scenes/frame/frame.h"

#include <filesystem>

namespace plumbline {

/// Writes to a temporary name in the same folder, then renames. Throws InputError if the place can't be
/// written.
void writeFrame(const Frame& frame, const std::filesystem::path& file);

/// Reads any EXR that readExr does: half, float and uint channels become float; channels the table lacks are
/// left out, string attributes become metadata. Throws InputError as readExr does, and for a file without any
/// channel of the table.
Frame readFrame(const std::filesystem::path& file);

} // namespace plumbline
