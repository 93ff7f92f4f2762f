#include "realtime/realtime.h"

#include "realtime/draw/frame_target.h"
#include "realtime/draw/gpu_scene.h"
#include "realtime/draw/micro_triangles.h"
#include "realtime/draw/shadow_maps.h"
#include "realtime/draw/technique_program.h"
#include "realtime/draw/view.h"
#include "realtime/gl/frame_timer.h"
#include "scenes/core/error.h"
#include "scenes/frame/frame_header.h"
#include "scenes/frame/header_fields.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

/// Everything that lives in the context, so that it can be dropped while the context is current.
struct GpuState {
    GpuState(const Scene& scene, const GlContext& context)
        : objects(scene, context), view(scene, objects.boundsWorld()), target(scene, context),
          plainProgram(buildPlainProgram(scene.lights.size(), false)) {
        objects.upload(view.originWorld());
    }
    GpuScene objects;
    View view;
    FrameTarget target;
    std::unique_ptr<GlProgram> plainProgram;
};

void checkMicroMeshes(const Technique& technique, const std::vector<MicroMesh>* meshes, size_t objectCount) {
    if (!meshes || meshes->size() != objectCount)
        throw InputError(technique.name(), "needs the reference's micro-triangles",
                         "a reference of the same scene");
    for (const MicroMesh& mesh : *meshes)
        if (mesh.normalsWorld.size() != mesh.positionsWorld.size() ||
            mesh.st.size() != mesh.positionsWorld.size())
            throw InputError(technique.name(), "the reference's micro-triangles have no normals and st",
                             "a reference with microAttributes");
}

/// What draws the proxies of a scene by one technique.
struct ProxyDrawer {
    ProxyDrawer(const Technique& technique, const Scene& scene, const GpuState& gpu, const GlContext& context)
        : relief(buildReliefProgram(technique, scene.lights.size())) {
        if (gpu.objects.hasReliefBacks(&BackSides::toCamera)) {
            reliefBack = buildReliefProgram(technique, scene.lights.size(), Side::Back);
            nearestPolygon = buildNearestPolygonProgram();
        }
        if (const Technique::Setting* bias = technique.harness("shadow_bias"))
            shadowBias = static_cast<float>(bias->value.number);
        if (!technique.readsShadowMaps()) return;
        plainWithMaps = buildPlainProgram(scene.lights.size(), true);
        shadowMaps.emplace(technique, scene, gpu.objects, gpu.view.originWorld(), context);
    }

    /// The camera's pass, into the framebuffer that is bound.
    void draw(const GpuState& gpu) const {
        if (reliefBack)
            gpu.target.markNearestBacks([&] {
                drawReliefs(gpu, *nearestPolygon, Side::Front);
                drawReliefs(gpu, *nearestPolygon, Side::Back);
            });
        const GlProgram& plain = plainWithMaps ? *plainWithMaps : *gpu.plainProgram;
        use(plain, gpu.view);
        gpu.objects.drawPlain(plain);
        drawReliefs(gpu, *relief, Side::Front);
        // Not behind a front side, also where a search finds its hit too far away: the far wall of a column
        // would show.
        if (reliefBack) gpu.target.drawOnNearestBacks([&] { drawReliefs(gpu, *reliefBack, Side::Back); });
    }

    void drawReliefs(const GpuState& gpu, const GlProgram& program, Side side) const {
        use(program, gpu.view);
        glUniform1f(program.uniform("uShadowBias"), shadowBias);
        gpu.objects.drawReliefs(program, side, &BackSides::toCamera);
    }

    void use(const GlProgram& program, const View& view) const {
        program.use();
        view.setUniforms(program);
        if (shadowMaps) shadowMaps->setUniforms(program);
    }

    std::unique_ptr<GlProgram> relief, plainWithMaps;
    std::unique_ptr<GlProgram> reliefBack, nearestPolygon; // null: no back sides
    std::optional<ShadowMaps> shadowMaps;
    float shadowBias = 0;
};

void drawMicroTriangles(const GpuState& gpu, MicroTriangleDrawer& drawer,
                        const std::vector<MicroMesh>& meshes) {
    gpu.plainProgram->use();
    gpu.view.setUniforms(*gpu.plainProgram);
    for (size_t i = 0; i < meshes.size(); ++i) {
        // As the reference: it sees both sides, unless they are culled.
        (gpu.objects.objects()[i].object->cull == Cull::Back ? glEnable : glDisable)(GL_CULL_FACE);
        gpu.objects.setUniforms(i, *gpu.plainProgram);
        drawer.draw(meshes[i], gpu.view.originWorld());
    }
}

} // namespace

struct RealtimeRenderer::Impl {
    Impl(const Scene& sceneToDraw, const GlOptions& options, std::shared_ptr<GlContext> opened)
        : scene(sceneToDraw), timingBudgetMs(options.timingBudgetMs), context(std::move(opened)) {
        const CurrentContext current(*context);
        gpu = std::make_unique<GpuState>(scene, *context);
    }
    ~Impl() {
        try {
            const CurrentContext current(*context);
            gpu.reset();
        } catch (const MachineError&) {
            static_cast<void>(gpu.release()); // the driver is gone and took the objects along
        }
    }

    FrameTime drawTechnique(const Technique& technique, const std::vector<MicroMesh>* meshes) const {
        if (technique.drawsMicroTriangles()) {
            MicroTriangleDrawer drawer;
            return drawFrame([] {}, [&] { drawMicroTriangles(*gpu, drawer, *meshes); });
        }
        const ProxyDrawer drawer(technique, scene, *gpu, *context);
        return drawFrame(
            [&] {
                if (drawer.shadowMaps) drawer.shadowMaps->draw(gpu->objects);
            },
            [&] { drawer.draw(*gpu); });
    }

    /// Warm-up and timed runs; the last frame drawn is the result. The light passes are part of what a frame
    /// takes.
    FrameTime drawFrame(const std::function<void()>& drawFromLights,
                        const std::function<void()>& drawFromCamera) const {
        clearGlErrors();
        FrameTime time = timeFrame(*context, timingBudgetMs, [&] {
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_LESS);
            drawFromLights();
            gpu->target.begin();
            drawFromCamera();
        });
        checkGl("drawing");
        return time;
    }

    Frame readFrame(const Technique& technique) const {
        // Micro-triangles carry st as it is.
        const std::vector<Vec2> stOrigins = technique.drawsMicroTriangles()
                                                ? std::vector<Vec2>(scene.objects.size(), Vec2(0))
                                                : gpu->objects.stOrigins();
        Frame frame = gpu->target.read(gpu->view.originWorld(), stOrigins, technique);
        // Not the driver: frames of different backends are equal byte for byte where their pixels are.
        frame.metadata = sceneMetadata(scene);
        frame.metadata[header::kRenderer] = "realtime";
        frame.metadata[header::kBase] = baseName(technique.drawsMicroTriangles() ? Base::Limit : Base::Proxy);
        frame.metadata[header::kTechnique] = technique.name();
        for (const auto& [name, value] : technique.parameters())
            frame.metadata[header::parameter(name)] = value;
        return frame;
    }

    const Scene& scene;
    double timingBudgetMs;
    std::shared_ptr<GlContext> context;
    std::unique_ptr<GpuState> gpu;
};

RealtimeRenderer::RealtimeRenderer(const Scene& scene, const GlOptions& options)
    : RealtimeRenderer(scene, options, createGlContext(options)) {}

RealtimeRenderer::RealtimeRenderer(const Scene& scene, const GlOptions& options,
                                   std::shared_ptr<GlContext> context)
    : impl_(std::make_unique<Impl>(scene, options, std::move(context))) {}

RealtimeRenderer::~RealtimeRenderer() = default;

TechniqueResult RealtimeRenderer::render(const Technique& technique,
                                         const std::vector<MicroMesh>* microMeshes,
                                         const PhaseCallback& onPhase) {
    if (technique.drawsMicroTriangles())
        checkMicroMeshes(technique, microMeshes, impl_->scene.objects.size());
    const CurrentContext current(*impl_->context);
    GpuScene& objects = impl_->gpu->objects;
    BakeCost bakes = objects.prepareBaked(technique);
    if (technique.hasCurvedBase()) objects.useCurvature(technique.curvatureSet());
    if (onPhase) onPhase(kPhaseDrawing);
    FrameTime time = impl_->drawTechnique(technique, microMeshes);

    TechniqueResult result;
    result.name = technique.name();
    result.parameters = technique.parameters();
    result.frame = impl_->readFrame(technique);
    result.backend = impl_->context->backend();
    result.renderer = impl_->context->renderer();
    result.msMedian = time.msMedian;
    result.msRuns = time.runs;
    result.timer = std::move(time.timer);
    result.bakeMs = bakes.ms;
    result.bakeBytes = bakes.bytes;
    result.warnings = std::move(bakes.warnings);
    return result;
}

} // namespace plumbline
