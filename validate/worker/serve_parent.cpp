#include "validate/worker/serve_parent.h"

#include "scenes/core/error.h"
#include "validate/worker/worker_process.h"
#include "validate/worker/worker_protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <new>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace plumbline {
namespace {

MessageSocket socketFromParent(const char* command) {
    struct stat status {};
    if (::fstat(kWorkerDescriptor, &status) != 0 || !S_ISSOCK(status.st_mode))
        throw InputError("plumbline", fmt::format("'{}' is an internal command", command),
                         "one of the commands that --help lists");
    ::fcntl(kWorkerDescriptor, F_SETFD, FD_CLOEXEC);
    return MessageSocket(kWorkerDescriptor);
}

/// Ends this process with its parent, even while a shader runs. Returns false if the parent has already
/// ended.
bool endWithParent(pid_t parent) {
    ::prctl(PR_SET_NAME, "plumbline"); // instead of "exe", as which it was started
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    return ::getppid() == parent; // otherwise the parent ended before
}

/// The parent receives these signals too and handles them; it ends this process if necessary.
void leaveSignalsToParent() {
    for (const int signal : {SIGINT, SIGQUIT, SIGHUP, SIGTERM})
        ::signal(signal, SIG_IGN);
}

/// stdout is for results, which the parent prints.
void sendPrintsToStderr() {
    if (::dup2(STDERR_FILENO, STDOUT_FILENO) >= 0) return;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    ::dup2(nowhere, STDOUT_FILENO);
    if (nowhere != STDOUT_FILENO) ::close(nowhere);
}

/// The parent says in its line that the process ended, and how.
[[noreturn]] void endForUncaught() {
    std::_Exit(kOutOfMemoryExit);
}

/// Sends the last message of a process that can't continue.
void sendError(const MessageSocket& socket, const std::exception& error) {
    try {
        socket.send(errorReply(error));
    } catch (const ConnectionLost&) { // the parent is gone
    }
}

} // namespace

int serveParent(pid_t parent, const char* command, const std::function<void(const MessageSocket&)>& serve) {
    const MessageSocket socket = socketFromParent(command);
    if (!endWithParent(parent)) return 0;
    leaveSignalsToParent();
    sendPrintsToStderr();
    std::set_terminate(endForUncaught);
    try {
        serve(socket);
    } catch (const ConnectionLost&) { // the regular end
    } catch (const std::bad_alloc&) {
        sendError(socket, MachineError(command, "this machine doesn't have enough memory",
                                       "a smaller scene or frame"));
    } catch (const std::exception& error) {
        sendError(socket, error);
    }
    return 0;
}

} // namespace plumbline
