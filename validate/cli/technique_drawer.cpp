#include "validate/cli/technique_drawer.h"

#include <algorithm>
#include <functional>

namespace plumbline {

WorkerOptions workerOptions(const std::filesystem::path& sceneFile, const Scene& scene,
                            const RealtimeArguments& arguments, int threads) {
    WorkerOptions options;
    options.sceneFile = sceneFile;
    options.sceneChanges = scene.changes;
    options.sceneHash = scene.hash;
    options.frameSize = {scene.camera.width, scene.camera.height};
    options.gl = arguments.gl.options;
    options.threads = threads;
    options.memoryBytes = arguments.drawMemory.bytes;
    options.timeLimitSeconds = arguments.timeLimitSeconds;
    return options;
}

TechniqueDrawer::TechniqueDrawer(const Scene& scene, const WorkerOptions& worker,
                                 const std::vector<ChosenTechnique>& techniques) {
    const auto controls =
        std::count_if(techniques.begin(), techniques.end(), std::mem_fn(&ChosenTechnique::isControl));
    // Both start at the same time.
    if (controls < std::ssize(techniques)) worker_ = std::make_unique<TechniqueWorker>(worker);
    if (controls > 0) control_ = std::make_unique<RealtimeRenderer>(scene, worker.gl);
    if (worker_) worker_->waitUntilReady();
}

TechniqueResult TechniqueDrawer::draw(const Technique& technique, const std::vector<MicroMesh>* microMeshes) {
    return technique.drawsMicroTriangles() ? control_->render(technique, microMeshes)
                                           : worker_->render(technique);
}

} // namespace plumbline
