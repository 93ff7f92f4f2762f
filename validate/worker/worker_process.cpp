#include "validate/worker/worker_process.h"

#include <unistd.h>

namespace plumbline {
namespace {

/// A process that has closed its end of the socket is about to end.
constexpr std::chrono::milliseconds kEnding(5000);

} // namespace

WorkerProcess::WorkerProcess(const std::filesystem::path& program, const char* command, int threads)
    : WorkerProcess(program, command, threads, MessageSocket::makePair()) {}

// The pair is destroyed after the call, so that only the process has its end. Otherwise this process wouldn't
// notice when it is closed.
WorkerProcess::WorkerProcess(const std::filesystem::path& program, const char* command, int threads,
                             std::pair<MessageSocket, MessageSocket> ends)
    : socket(std::move(ends.first)),
      process(program,
              {"plumbline", command, std::to_string(::getpid()), "--threads", std::to_string(threads)},
              ends.second.descriptor(), kWorkerDescriptor) {}

std::string WorkerProcess::howItEnded() {
    process.waitForEnd(kEnding);
    return process.howItEnded();
}

} // namespace plumbline
