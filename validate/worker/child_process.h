// A program started by this one.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace plumbline {

/// Owns the process: it doesn't outlive this.
class ChildProcess {
  public:
    /// The child finds `descriptor` under the number `descriptorThere`; standard streams, environment and
    /// working folder are this process's. Throws MachineError if it can't be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 int descriptor, int descriptorThere);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Whether it has ended before `limit` was over.
    bool waitForEnd(std::chrono::milliseconds limit);
    /// Kills it if it still runs.
    void stop();
    /// The signal it ended by; 0: none, or it isn't known to have ended.
    int signal() const;
    /// "signal 11, SIGSEGV" or "exit code 1", once it has ended.
    std::string howItEnded() const;

  private:
    pid_t process_ = -1;
    std::optional<int> status_; // of waitpid, once it has ended
};

} // namespace plumbline
