// A scene drawn by one technique with OpenGL, headless: the approximation under test.
//
// World space and world units throughout. Never includes reference/.
#pragma once

#include "realtime/gl/gl_options.h"
#include "realtime/technique/technique.h"
#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/micro_mesh.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

struct TechniqueResult {
    std::string name;    // as in every result: search@surface:changed=parameters
    Settings parameters; // all of them, with the values used
    Frame frame;
    std::string backend, renderer; // "egl", GL_RENDERER
    double msMedian = 0;           // of one frame, warm
    int msRuns = 0;
    std::string timer; // "gpu timer query", "wall clock around glFinish[, one cold run]"
    double bakeMs = 0; // of making its baked maps, now or when they came into the cache
    uint64_t bakeBytes = 0;
    std::vector<std::string> warnings;
};

/// Called with what `render` is about to do.
using PhaseCallback = std::function<void(std::string_view phase)>;
inline constexpr std::string_view kPhaseDrawing = "drawing"; // the author's shader compiles, then runs

class GlContext;

/// Holds a GL context and what techniques share: proxy meshes, height maps.
class RealtimeRenderer {
  public:
    /// Throws MachineError if there is no GL as asked for. The scene must outlive the renderer.
    RealtimeRenderer(const Scene& scene, const GlOptions& options);
    /// In a context opened before (gl_context.h), as `options` ask for. Renderers that share one must be used
    /// one after the other.
    RealtimeRenderer(const Scene& scene, const GlOptions& options, std::shared_ptr<GlContext> context);
    ~RealtimeRenderer();

    /// `microMeshes`: one per object, or null. Throws InputError for a shader (file:line), for maps or meshes
    /// the scene can't give the technique.
    TechniqueResult render(const Technique& technique, const std::vector<MicroMesh>* microMeshes,
                           const PhaseCallback& onPhase = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace plumbline
