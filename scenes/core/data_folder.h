// Where the files that ship with the program are: scenes/library, realtime/techniques, realtime/shaders, …
#pragma once

#include <filesystem>

namespace plumbline {

/// The folder of the running executable, symbolic links followed; empty where /proc can't tell.
std::filesystem::path programFolder();

/// Folder that has `scenes/`, `realtime/` and `validate/` as subfolders: chooseDataFolder() of
/// $PLUMBLINE_DATA, programFolder() and the source tree the program was built from.
std::filesystem::path dataFolder();

/// `fromEnvironment` unless null or empty; else `../share/plumbline` beside `program` if there is such a
/// folder (an installed program); else `sourceTree`. Throws MachineError if the one chosen lacks a subfolder:
/// the next isn't tried.
std::filesystem::path chooseDataFolder(const char* fromEnvironment, const std::filesystem::path& program,
                                       const std::filesystem::path& sourceTree);

} // namespace plumbline
