// Draws the techniques of a run: each in a process that can be stopped (worker/), but for the control
// technique, whose triangles are in this one.
#pragma once

#ifdef PLUMBLINE_GL
#include "validate/cli/realtime_arguments.h"
#include "validate/worker/technique_worker.h"

namespace plumbline {

/// `threads`: as of --threads. Throws InputError for a --gl there isn't.
WorkerOptions workerOptions(const std::filesystem::path& sceneFile, const Scene& scene,
                            const RealtimeArguments& arguments, int threads);

class TechniqueDrawer {
  public:
    /// Starts OpenGL where `requests` will need it. Throws MachineError where there is none. The scene must
    /// outlive this.
    TechniqueDrawer(const Scene& scene, const WorkerOptions& worker,
                    const std::vector<TechniqueRequest>& requests);

    /// As RealtimeRenderer::render and TechniqueWorker::render.
    TechniqueResult draw(const TechniqueRequest& request, const std::map<std::string, std::string>& settings,
                         const std::vector<MicroMesh>* microMeshes);

  private:
    std::unique_ptr<TechniqueWorker> worker_;
    std::unique_ptr<RealtimeRenderer> control_;
};

} // namespace plumbline
#endif
