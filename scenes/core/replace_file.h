// Writes files atomically: under a temporary name in the same folder, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace plumbline {

/// Calls `write` with a temporary path beside `file`, then renames it to `file`, replacing what was there.
/// When `write` throws, the temporary file is removed and `file` stays as it was. Throws InputError if the
/// folder is missing or can't be written, or if `file` exists and isn't a regular file (a folder, or a device
/// such as /dev/null, which renaming would replace).
void replaceFile(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same with contents in memory.
void replaceFile(const std::filesystem::path& file, std::string_view contents);

} // namespace plumbline
