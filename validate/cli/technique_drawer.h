// Draws the techniques of a run: each in a process that can be stopped (worker/), but for the control
// technique, whose triangles are in this one.
#pragma once

#include "validate/cli/chosen_techniques.h"
#include "validate/cli/realtime_arguments.h"
#include "validate/worker/technique_worker.h"

namespace plumbline {

/// `threads`: as of --threads.
WorkerOptions workerOptions(const std::filesystem::path& sceneFile, const Scene& scene,
                            const RealtimeArguments& arguments, int threads);

class TechniqueDrawer {
  public:
    /// Starts OpenGL where `techniques` will need it. Throws MachineError where there is none. The scene must
    /// outlive this.
    TechniqueDrawer(const Scene& scene, const WorkerOptions& worker,
                    const std::vector<ChosenTechnique>& techniques);

    /// One of them, as RealtimeRenderer::render and TechniqueWorker::render.
    TechniqueResult draw(const Technique& technique, const std::vector<MicroMesh>* microMeshes);

  private:
    std::unique_ptr<TechniqueWorker> worker_;
    std::unique_ptr<RealtimeRenderer> control_;
};

} // namespace plumbline
