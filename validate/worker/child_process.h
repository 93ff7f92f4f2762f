// A child process that runs a program.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace plumbline {

/// Owns the process, which is killed in the destructor.
class ChildProcess {
  public:
    /// `descriptor` has the number `descriptorThere` in the child. Standard streams, environment and working
    /// folder are inherited. Throws MachineError if it can't be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 int descriptor, int descriptorThere);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Waits for its end, at most `limit`; returns whether it has ended.
    bool waitForEnd(std::chrono::milliseconds limit);
    /// Kills it if it is still running.
    void stop();
    /// The signal that ended it; 0: none, or it isn't known to have ended.
    int signal() const;
    /// "signal 11, SIGSEGV" or "exit code 1", once it has ended.
    std::string howItEnded() const;

  private:
    pid_t process_ = -1;
    std::optional<int> status_; // from waitpid, once it has ended
};

} // namespace plumbline
