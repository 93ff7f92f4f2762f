// Where the files that ship with the program are: scenes/library, realtime/techniques, realtime/shaders, …
#pragma once

#include <filesystem>

namespace plumbline {

/// Folder that has `scenes/`, `realtime/` and `validate/` as subfolders: $PLUMBLINE_DATA if set, else the source tree
/// the program was built from. Throws MachineError if it isn't there.
std::filesystem::path dataFolder();

} // namespace plumbline
