// What `cmake --install` makes of the build, in a folder of the test's.
#pragma once

#include "tests/end_to_end/program.h"

namespace plumbline::test {

/// stdout and stderr together, of a command of the shell. Without what the environment says of data and
/// libraries.
struct ShellOutcome {
    int exitCode = -1;
    std::string text;
};
ShellOutcome shell(const std::string& command);

/// Installs to folder/prefix and moves that to folder/moved, which is returned. `components`: on top of what
/// is installed by default.
std::filesystem::path installAndMove(const std::filesystem::path& folder,
                                     const std::vector<std::string>& components = {});

} // namespace plumbline::test
