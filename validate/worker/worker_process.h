// A worker process of this program, as its parent sees it. serve_parent.h is its own side.
#pragma once

#include "validate/worker/child_process.h"
#include "validate/worker/message_socket.h"

#include <filesystem>

namespace plumbline {

/// The descriptor of its socket. It isn't stdin, stdout or stderr, so that output of a driver isn't mixed
/// with messages.
inline constexpr int kWorkerDescriptor = 3;

/// Its exit code after an exception that nothing could catch: without memory, libraries throw where they
/// promise not to.
inline constexpr int kOutOfMemoryExit = 3;

struct WorkerProcess {
    /// Runs `program COMMAND PARENT --threads THREADS`, where PARENT is this process. Throws MachineError.
    WorkerProcess(const std::filesystem::path& program, const char* command, int threads);

    /// How a process that has closed its end of the socket ended: "signal 11, SIGSEGV" or "exit code 1".
    std::string howItEnded();

    MessageSocket socket;
    ChildProcess process;

  private:
    WorkerProcess(const std::filesystem::path& program, const char* command, int threads,
                  std::pair<MessageSocket, MessageSocket> ends);
};

} // namespace plumbline
