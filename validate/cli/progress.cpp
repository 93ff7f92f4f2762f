#include "validate/cli/progress.h"

#include "scenes/core/printable.h"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace plumbline {
namespace {

constexpr const char* kClearLine = "\r\033[K";

bool stderrIsTerminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

} // namespace

Progress::Progress() : terminal_(stderrIsTerminal()) {}

Progress::~Progress() {
    if (terminal_) std::fputs(kClearLine, stderr);
}

void Progress::step(const std::string& what) {
    step_ = what;
    if (!terminal_) return;
    std::fputs((kClearLine + printable(what) + " …").c_str(), stderr);
    std::fflush(stderr);
}

void Progress::say(const std::string& line) {
    if (terminal_) std::fputs(kClearLine, stderr);
    std::fputs((printable(line) + "\n").c_str(), stderr);
    step(step_);
}

void printWarnings(const std::vector<std::string>& warnings) {
    const bool terminal = stderrIsTerminal(); // where a line of progress may stand
    for (const std::string& warning : warnings)
        fmt::print(stderr, "{}warning: {}\n", terminal ? kClearLine : "", printable(warning));
}

} // namespace plumbline
