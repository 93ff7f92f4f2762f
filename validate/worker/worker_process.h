// A process of this program that works for this one. Its own side is serve_parent.h.
#pragma once

#include "validate/worker/child_process.h"
#include "validate/worker/message_socket.h"

#include <filesystem>

namespace plumbline {

/// The number under which it finds its socket: not stdin, stdout or stderr, so that nothing a driver prints
/// gets among the messages.
inline constexpr int kWorkerDescriptor = 3;

struct WorkerProcess {
    /// Runs `program COMMAND PARENT --threads THREADS`, PARENT this process. Throws MachineError.
    WorkerProcess(const std::filesystem::path& program, const char* command, int threads);

    /// Of one that has closed its end of the socket: "signal 11, SIGSEGV" or "exit code 1".
    std::string howItEnded();

    MessageSocket socket;
    ChildProcess process;

  private:
    WorkerProcess(const std::filesystem::path& program, const char* command, int threads,
                  std::pair<MessageSocket, MessageSocket> ends);
};

} // namespace plumbline
