#include "realtime/gl/gl_probe.h"

#include "realtime/gl/gl_context.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

template <class Open>
GlProbe probe(std::string backend, Open open) {
    try {
        requireDriverSpace();
        const std::unique_ptr<GlContext> context = open();
        return {std::move(backend), true,
                fmt::format("{}, OpenGL {}", context->renderer(), context->version())};
    } catch (const MachineError& error) {
        return {std::move(backend), false, error.what()};
    }
}

} // namespace

std::vector<GlProbe> probeGl() {
    std::vector<GlProbe> probes;
    probes.push_back(probe("egl", [] { return createEglContext(-1); }));
    for (int device = 0; device < eglDeviceCount(); ++device)
        probes.push_back(
            probe(fmt::format("egl device {}", device), [device] { return createEglContext(device); }));
    probes.push_back(probe("osmesa", [] { return createOsmesaContext(); }));
    return probes;
}

void requireGlBuild(std::string_view, std::string_view, std::string_view) {}

} // namespace plumbline
