#include "validate/cli/technique_drawer.h"

#include "validate/cli/shared.h"

#include <algorithm>

namespace plumbline {

WorkerOptions workerOptions(const std::filesystem::path& sceneFile, const Scene& scene,
                            const RealtimeArguments& arguments, int threads) {
    WorkerOptions options;
    options.sceneFile = sceneFile;
    options.sceneChanges = scene.changes;
    options.sceneHash = scene.hash;
    options.gl = arguments.gl.options();
    options.threads = threads;
    options.timeLimitSeconds = arguments.timeLimitSeconds;
    return options;
}

TechniqueDrawer::TechniqueDrawer(const Scene& scene, const WorkerOptions& worker,
                                 const std::vector<TechniqueRequest>& requests) {
    const auto controls = std::count_if(requests.begin(), requests.end(), drawsMicroTriangles);
    // Both start at the same time.
    if (controls < std::ssize(requests)) worker_ = std::make_unique<TechniqueWorker>(worker);
    if (controls > 0) control_ = std::make_unique<RealtimeRenderer>(scene, worker.gl);
    if (worker_) worker_->waitUntilReady();
}

TechniqueResult TechniqueDrawer::draw(const TechniqueRequest& request,
                                      const std::map<std::string, std::string>& settings,
                                      const std::vector<MicroMesh>* microMeshes) {
    if (drawsMicroTriangles(request)) return control_->render(request, settings, microMeshes);
    return worker_->render(request, settings);
}

} // namespace plumbline
