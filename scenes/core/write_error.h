// What a system call that failed on an output file means to a person.
#pragma once

#include <filesystem>

namespace plumbline {

/// Throws "file: can't be written: reason": MachineError for what the machine lacks (space, a file-size
/// limit, open files, a disk that works), InputError for what another path would mend. `error`: an errno.
[[noreturn]] void failWrite(const std::filesystem::path& file, int error);

} // namespace plumbline
