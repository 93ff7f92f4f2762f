// A scene drawn by one technique with OpenGL, headless: the approximation under test.
//
// World space and world units throughout. Never includes reference/.
#pragma once

#include "scenes/frame/frame.h"
#include "scenes/scene/scene.h"
#include "scenes/surface/micro_mesh.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

enum class GlBackend { Auto, Egl, Osmesa };

struct GlOptions {
    GlBackend backend = GlBackend::Auto; // Auto: EGL, else OSMesa
    int device = -1;                     // EGL device to open; -1 = surfaceless, or the first that works
    double timingBudgetMs = 1000;        // spent on timing each technique; 0: it is drawn once, cold
};

/// What a machine offers; for `plumbline doctor`.
struct GlProbe {
    std::string backend; // "egl", "egl device 0", "osmesa"
    bool works = false;
    std::string detail; // renderer and version, or why it doesn't work
};
std::vector<GlProbe> probeGl();

/// A technique as the user named it: SEARCH[@SURFACE][:key=value,…], SEARCH a name in realtime/techniques/ or
/// a folder.
struct TechniqueRequest {
    std::string search; // name or path
    std::string surface = "flat";
    std::map<std::string, std::string> settings; // of this technique alone
};
/// Throws InputError for a text that doesn't have this form.
TechniqueRequest parseTechnique(const std::string& text);

struct TechniqueInfo {
    std::string name, title, citation, folder;
    std::vector<std::string> inputs;             // "height", …
    std::vector<std::string> surfaces;           // it composes with; empty: none
    std::map<std::string, std::string> refusals; // why not with others, by surface
    std::vector<std::string> shadows; // "relief": its search also serves as a shadow ray; "none"; "map"
    struct Parameter {
        std::string name, type, unit, meaning, defaultValue, range;
    };
    std::vector<Parameter> parameters;
    std::vector<std::string> limits;  // known limits, a sentence each
    bool drawsMicroTriangles = false; // the control technique: needs the reference's micro-meshes
};
/// Every technique of realtime/techniques/, sorted by name.
std::vector<TechniqueInfo> listTechniques();

struct SurfaceInfo {
    std::string name, title, citation;
    std::string variantOf;            // the surface it does otherwise; may be empty
    std::vector<std::string> inputs;  // "quadric" (without cross term), "quadric_full", or nothing
    std::vector<std::string> shadows; // as of TechniqueInfo; both have to allow one
    std::vector<TechniqueInfo::Parameter> parameters;
    std::vector<std::string> limits;
};
/// Every surface of realtime/surfaces/, sorted by name.
std::vector<SurfaceInfo> listSurfaces();

struct TechniqueResult {
    std::string name;                              // as in every result: search@surface:changed=parameters
    std::map<std::string, std::string> parameters; // all of them, with the values used
    Frame frame;
    std::string backend, renderer; // "egl", GL_RENDERER
    double msMedian = 0;           // of one frame, warm
    int msRuns = 0;
    std::string timer; // "gpu timer query", "wall clock around glFinish[, one cold run]"
    double bakeMs = 0; // of making its baked maps, now or when they came into the cache
    uint64_t bakeBytes = 0;
    std::vector<std::string> warnings;
};

/// Told what `render` is about to do.
using PhaseCallback = std::function<void(std::string_view phase)>;
inline constexpr std::string_view kPhaseDrawing = "drawing"; // the author's shader compiles, then runs

class GlContext;

/// Owns a GL context and what techniques share: proxy meshes, height maps.
class RealtimeRenderer {
  public:
    /// Throws MachineError if there is no GL as asked for. The scene must outlive the renderer.
    RealtimeRenderer(const Scene& scene, const GlOptions& options);
    /// In a context opened before (gl_context.h), as `options` ask for.
    RealtimeRenderer(const Scene& scene, const GlOptions& options, std::unique_ptr<GlContext> context);
    ~RealtimeRenderer();

    /// `shared`: settings for every technique (`--set`); keys a technique doesn't know are ignored here, and
    /// the caller must check that at least one technique knows each (see knownSettings). `microMeshes`: one
    /// per object, or null. Throws InputError for a technique that can't be used: unknown, manifest,
    /// parameter, shader (file:line).
    TechniqueResult render(const TechniqueRequest& request, const std::map<std::string, std::string>& shared,
                           const std::vector<MicroMesh>* microMeshes, const PhaseCallback& onPhase = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Names of the settings a technique takes: its own, its surface's and the harness's.
std::vector<std::string> knownSettings(const TechniqueRequest& request);
/// The manifest of a request's search. Throws InputError.
TechniqueInfo techniqueInfo(const TechniqueRequest& request);
/// Name as results show it; for a technique whose manifest can't be read, as the user wrote it.
std::string displayName(const TechniqueRequest& request, const std::map<std::string, std::string>& settings);
/// Name as results show it, without drawing.
std::string techniqueName(const TechniqueRequest& request, const std::map<std::string, std::string>& shared);

} // namespace plumbline
