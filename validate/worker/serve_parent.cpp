#include "validate/worker/serve_parent.h"

#include "scenes/core/error.h"
#include "validate/worker/worker_process.h"
#include "validate/worker/worker_protocol.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <csignal>
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
        throw InputError("plumbline", fmt::format("'{}' is for the program itself", command),
                         "one of the commands that --help lists");
    ::fcntl(kWorkerDescriptor, F_SETFD, FD_CLOEXEC);
    return MessageSocket(kWorkerDescriptor);
}

/// Also in the middle of a shader.
bool endWithParent(pid_t parent) {
    ::prctl(PR_SET_NAME, "plumbline"); // not "exe", what it was started as
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    return ::getppid() == parent; // else that was too late
}

/// They come to the parent as well, whose they are; what it does about them ends this process, if it is to
/// end.
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

/// The last message of a process that can't go on.
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
    try {
        serve(socket);
    } catch (const ConnectionLost&) { // how it ends
    } catch (const std::bad_alloc&) {
        sendError(socket, MachineError(command, "this machine hasn't the memory for that",
                                       "a smaller scene or frame"));
    } catch (const std::exception& error) {
        sendError(socket, error);
    }
    return 0;
}

} // namespace plumbline
