#include "tests/end_to_end/installed_program.h"

#include <array>
#include <cstdio>
#include <sys/wait.h>

namespace plumbline::test {

ShellOutcome shell(const std::string& command) {
    ShellOutcome outcome;
    FILE* pipe = popen(("unset PLUMBLINE_DATA LD_LIBRARY_PATH; exec 2>&1; " + command).c_str(), "r");
    if (!pipe) return outcome;
    std::array<char, 4096> buffer;
    while (const size_t count = fread(buffer.data(), 1, buffer.size(), pipe))
        outcome.text.append(buffer.data(), count);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
    return outcome;
}

std::filesystem::path installAndMove(const std::filesystem::path& folder,
                                     const std::vector<std::string>& components) {
    const std::filesystem::path prefix = folder / "prefix", moved = folder / "moved";
    const std::string install =
        "'" PLUMBLINE_CMAKE "' --install '" PLUMBLINE_BUILD "' --prefix '" + prefix.string() + "'";
    std::vector<std::string> commands{install};
    for (const std::string& component : components)
        commands.push_back(install + " --component " + component);
    for (const std::string& command : commands) {
        const ShellOutcome outcome = shell(command);
        EXPECT_EQ(outcome.exitCode, 0) << command << '\n' << outcome.text;
    }
    std::filesystem::rename(prefix, moved);
    return moved;
}

} // namespace plumbline::test
