// A child process that runs a program.
#pragma once

#include <chrono>
#include <cstdint>
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
    /// Nothing if a signal ended it, or it isn't known to have ended.
    std::optional<int> exitCode() const;
    /// Its largest resident set, once it has ended; 0 if that isn't known.
    uint64_t peakBytes() const { return peakBytes_; }
    /// "signal 11, SIGSEGV" or "exit code 1", once it has ended.
    std::string howItEnded() const;

  private:
    pid_t process_ = -1;
    std::optional<int> status_; // from wait4, once it has ended
    uint64_t peakBytes_ = 0;
};

} // namespace plumbline
