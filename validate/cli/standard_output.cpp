#include "validate/cli/standard_output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

namespace plumbline {

void openClosedStreams() {
    // The lowest free number is the one that open() returns. Read-only: printing is to fail as before.
    while (true) {
        const int opened = ::open("/dev/null", O_RDONLY);
        if (opened > STDERR_FILENO) ::close(opened);
        if (opened < 0 || opened > STDERR_FILENO) return;
    }
}

MachineError unwrittenOutput() {
    const std::string reason = errno != 0 ? fmt::format(" ({})", std::strerror(errno)) : "";
    return {"standard output", "not all of it can be written" + reason, "a place that takes the results"};
}

void finishStandardOutput() {
    errno = 0;
    const bool failedBefore = std::ferror(stdout) != 0 || !std::cout; // CLI11 prints --help to std::cout
    std::cout.flush();
    const bool failed = std::fflush(stdout) != 0 || failedBefore || !std::cout;
    if (!failed) return;
    throw unwrittenOutput();
}

} // namespace plumbline
