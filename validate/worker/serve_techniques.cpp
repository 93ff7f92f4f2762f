#include "validate/worker/serve_techniques.h"

#include "realtime/gl/gl_context.h"
#include "scenes/core/error.h"
#include "scenes/scene_file/scene_file.h"
#include "validate/worker/serve_parent.h"
#include "validate/worker/technique_worker.h"
#include "validate/worker/worker_protocol.h"

#include <nlohmann/json.hpp>

namespace plumbline {
namespace {

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
