// What the library is in a build without OpenGL (preset no-gl), in place of its other sources: it draws
// nothing and says so.
#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_probe.h"
#include "realtime/realtime.h"
#include "scenes/core/error.h"

namespace plumbline {
namespace {

MachineError builtWithoutGl(std::string_view where, std::string_view expected, std::string_view hint = {}) {
    return {where, "this program was built without OpenGL (preset no-gl)", expected, hint};
}

MachineError cannotDraw() {
    return builtWithoutGl("OpenGL", "a build with it");
}

} // namespace

std::vector<GlProbe> probeGl() {
    return {};
}

void requireGlBuild(std::string_view where, std::string_view expected, std::string_view hint) {
    throw builtWithoutGl(where, expected, hint);
}

std::unique_ptr<GlContext> createGlContext(const GlOptions&) {
    throw cannotDraw();
}

struct RealtimeRenderer::Impl {};

RealtimeRenderer::RealtimeRenderer(const Scene&, const GlOptions&) {
    throw cannotDraw();
}

RealtimeRenderer::RealtimeRenderer(const Scene&, const GlOptions&, std::shared_ptr<GlContext>) {
    throw cannotDraw();
}

RealtimeRenderer::~RealtimeRenderer() = default;

TechniqueResult RealtimeRenderer::render(const Technique&, const std::vector<MicroMesh>*,
                                         const PhaseCallback&) {
    throw cannotDraw();
}

} // namespace plumbline
