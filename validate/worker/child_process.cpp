#include "validate/worker/child_process.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace plumbline {
namespace {

/// Time that a killed process may take to end. If a GPU hangs, it can take longer in the driver; the process
/// is then abandoned.
constexpr std::chrono::seconds kKillLimit(10);
constexpr std::chrono::milliseconds kPollInterval(1);

} // namespace

// Not fork(): the child would have only one of this process's threads, but the locks of all of them.
ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           int descriptor, int descriptorThere) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str())); // POSIX guarantees that they aren't modified
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, descriptor, descriptorThere);
    const int error = ::posix_spawn(&process_, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw MachineError(program.string(), fmt::format("can't be started ({})", std::strerror(error)));
}

ChildProcess::~ChildProcess() {
    stop();
}

bool ChildProcess::waitForEnd(std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!status_) {
        int status = 0;
        rusage usage{};
        const pid_t ended = ::wait4(process_, &status, WNOHANG, &usage);
        // -1: this program was started with SIGCHLD ignored, so it can't get the status of its children.
        if (ended == process_ || (ended < 0 && errno != EINTR)) status_ = status;
        if (ended == process_)
            peakBytes_ = static_cast<uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
        if (status_ || std::chrono::steady_clock::now() >= end) break;
        std::this_thread::sleep_for(kPollInterval);
    }
    return status_.has_value();
}

void ChildProcess::stop() {
    if (waitForEnd(std::chrono::milliseconds(0))) return;
    ::kill(process_, SIGKILL);
    waitForEnd(kKillLimit);
}

int ChildProcess::signal() const {
    return status_ && WIFSIGNALED(*status_) ? WTERMSIG(*status_) : 0;
}

std::optional<int> ChildProcess::exitCode() const {
    if (!status_ || !WIFEXITED(*status_)) return std::nullopt;
    return WEXITSTATUS(*status_);
}

std::string ChildProcess::howItEnded() const {
    if (!status_) return "exit status unknown";
    if (!WIFSIGNALED(*status_)) return fmt::format("exit code {}", WEXITSTATUS(*status_));
    const char* name = ::sigabbrev_np(signal());
    return name ? fmt::format("signal {}, SIG{}", signal(), name) : fmt::format("signal {}", signal());
}

} // namespace plumbline
