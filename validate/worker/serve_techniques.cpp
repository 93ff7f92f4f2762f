// The side of the process that draws; technique_worker.h has the other.
#include "../../scenes/error.h"
#include "../../scenes/scene_file.h"
#include "technique_worker.h"
#include "worker_descriptor.h"
#include "worker_protocol.h"

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

MessageSocket socketFromParent() {
    struct stat status {};
    if (::fstat(kWorkerDescriptor, &status) != 0 || !S_ISSOCK(status.st_mode))
        throw InputError("plumbline", fmt::format("'{}' is for the program itself", kDrawWorkerCommand),
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

/// They come to the parent as well, whose they are; what it does about them ends this process, if it is to end.
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

/// The file may be another by the time a new process is started.
Scene readSameScene(const WorkerSetup& setup) {
    Scene scene = readScene(setup.scene, setup.sceneChanges);
    if (scene.hash != setup.sceneHash)
        throw InputError(setup.scene.string(), "the scene changed during the run",
                         "the files it had at the start");
    return scene;
}

void drawTechnique(const MessageSocket& socket, RealtimeRenderer& renderer, const DrawRequest& request) {
    const auto tellPhase = [&](std::string_view phase) { socket.send(phaseReply(phase)); };
    try {
        sendResult(socket, renderer.render(request.technique, request.settings, nullptr, tellPhase));
    } catch (const InputError& error) {
        socket.send(errorReply(error)); // the others go on
    }
}

void drawTechniques(const MessageSocket& socket) {
    const WorkerSetup setup = workerSetup(socket.receive());
    const Scene scene = readSameScene(setup);
    RealtimeRenderer renderer(scene, setup.gl);
    socket.send(phaseReply(kPhaseReady));
    for (;;)
        drawTechnique(socket, renderer, drawRequest(socket.receive()));
}

/// The last word of a process that can't go on.
void tellError(const MessageSocket& socket, const std::exception& error) {
    try {
        socket.send(errorReply(error));
    } catch (const ConnectionLost&) { // nobody is left to tell
    }
}

} // namespace

int serveTechniques(pid_t parent) {
    const MessageSocket socket = socketFromParent();
    if (!endWithParent(parent)) return 0;
    leaveSignalsToParent();
    sendPrintsToStderr();
    try {
        drawTechniques(socket);
    } catch (const ConnectionLost&) { // how it ends
    } catch (const std::bad_alloc&) {
        tellError(socket, MachineError("drawing", "this machine hasn't the memory for that",
                                       "a smaller scene or frame"));
    } catch (const std::exception& error) {
        tellError(socket, error);
    }
    return 0;
}

} // namespace plumbline
