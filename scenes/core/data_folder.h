// Where the files that ship with the program are: scenes/library, realtime/techniques, realtime/shaders, …
#pragma once

#include <filesystem>

namespace plumbline {

/// The folder of the running executable with symbolic links resolved; empty if /proc can't be read.
std::filesystem::path programFolder();

/// The folder that contains `scenes/`, `realtime/` and `validate/`: chooseDataFolder() applied to
/// $PLUMBLINE_DATA, programFolder() and the source tree the program was built from.
std::filesystem::path dataFolder();

/// `fromEnvironment` unless it is null or empty; otherwise `../share/plumbline` relative to `program` if that
/// folder exists (an installed program); otherwise `sourceTree`. Throws MachineError if the chosen folder
/// lacks a subfolder; it does not fall back to the next candidate.
std::filesystem::path chooseDataFolder(const char* fromEnvironment, const std::filesystem::path& program,
                                       const std::filesystem::path& sourceTree);

} // namespace plumbline
