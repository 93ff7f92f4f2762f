// Reads whole files into memory.
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

/// Throws InputError if the file is missing, not a regular file, unreadable, empty or longer than 2^30 bytes.
std::string readWholeFile(const std::filesystem::path& file);

} // namespace plumbline
