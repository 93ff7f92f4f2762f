// Writes files atomically: under a temporary name in the same folder, then renamed. Every output file of the
// program is written here.
#pragma once

#include "scenes/core/output_stream.h"

#include <functional>

namespace plumbline {

/// Calls `write` with an empty file beside `file`, then renames that to `file`, replacing what was there.
/// When `write` throws, nothing is left of it and `file` stays as it was. What it returned from is on the
/// disk.
///
/// A symbolic link stays one, and its target is replaced. The new file has the mode of the old one, and its
/// owner and group where this process may give them away. A file that wasn't there gets what the umask
/// leaves. Throws as failWrite does, and InputError if the folder is missing, or if `file` exists and isn't a
/// regular file (a folder, or a device such as /dev/null, which renaming would replace).
void replaceFile(const std::filesystem::path& file, const std::function<void(OutputStream& stream)>& write);

/// The same with contents in memory.
void replaceFile(const std::filesystem::path& file, std::string_view contents);

/// The file that a path leads to in the end, whether it exists or not: `file` itself if it isn't a symbolic
/// link. Throws InputError for links that lead in circles.
std::filesystem::path linkTarget(const std::filesystem::path& file);

/// The folder of a file: "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

} // namespace plumbline
