// Whole files in memory.
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

/// Throws InputError: missing, not a regular file, not readable, empty or longer than 1 GB.
std::string readWholeFile(const std::filesystem::path& file);

} // namespace plumbline
