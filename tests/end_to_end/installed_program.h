// Runs `cmake --install` in a folder of the test and the installed program.
#pragma once

#include "tests/end_to_end/program.h"

namespace plumbline::test {

/// stdout and stderr of a shell command, which runs without environment variables for data and libraries.
struct ShellOutcome {
    int exitCode = -1;
    std::string text;
};
ShellOutcome shell(const std::string& command);

/// Installs to folder/prefix, moves that to folder/moved, and returns the latter. `components`: in addition
/// to those installed by default.
std::filesystem::path installAndMove(const std::filesystem::path& folder,
                                     const std::vector<std::string>& components = {});

} // namespace plumbline::test
