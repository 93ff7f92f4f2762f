#include "validate/worker/serve_techniques.h"

#include "realtime/gl/gl_context.h"
#include "scenes/core/error.h"
#include "scenes/scene_file/scene_file.h"
#include "validate/worker/serve_parent.h"
#include "validate/worker/technique_worker.h"
#include "validate/worker/worker_protocol.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sys/resource.h>

namespace plumbline {
namespace {

/// A shader that takes ever more memory to compile ends this process, not one that the kernel chooses.
/// RLIMIT_DATA, not RLIMIT_AS: it leaves out what drivers of GPUs only reserve, which is many times the
/// memory.
void limitMemory(uint64_t bytes) {
    rlimit limit{};
    if (bytes == 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    ::setrlimit(RLIMIT_DATA, &limit);
}

/// The file may have changed before a new process is started.
Scene readSameScene(const WorkerSetup& setup) {
    Scene scene = readScene(setup.scene, setup.sceneChanges);
    if (scene.hash != setup.sceneHash)
        throw InputError(setup.scene.string(), "the scene changed during the run",
                         "the same files as at the start");
    return scene;
}

void drawTechnique(const MessageSocket& socket, RealtimeRenderer& renderer, const TechniqueRequest& request) {
    const auto sendPhase = [&](std::string_view phase) { socket.send(phaseReply(phase)); };
    try {
        sendResult(socket, renderer.render(resolveTechnique(request), nullptr, sendPhase));
    } catch (const InputError& error) {
        socket.send(errorReply(error)); // the next techniques are drawn all the same
    }
}

void drawTechniques(const MessageSocket& socket) {
    const WorkerSetup setup = workerSetup(socket.receive());
    limitMemory(setup.memoryBytes);
    // Before the scene is read, because its maps load the image libraries. These load copies of libraries
    // (libdrm, libxcb) that drivers also link, and a driver must get its own.
    std::unique_ptr<GlContext> context = createGlContext(setup.gl);
    const Scene scene = readSameScene(setup);
    RealtimeRenderer renderer(scene, setup.gl, std::move(context));
    socket.send(phaseReply(kPhaseReady));
    for (;;)
        drawTechnique(socket, renderer, techniqueRequest(socket.receive()));
}

} // namespace

int serveTechniques(pid_t parent) {
    return serveParent(parent, kDrawWorkerCommand, drawTechniques);
}

} // namespace plumbline
