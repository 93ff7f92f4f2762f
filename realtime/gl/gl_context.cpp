#include "realtime/gl/gl_context.h"

#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <thread>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
// Suppresses OSMesa's own leaks at exit: the buffers of its contexts, 1.3 KB after 60 tests.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\n";
}
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0"; // keep stderr for the program's messages
}
#endif

namespace plumbline {
namespace {

// The context whose functions are loaded. Global, because glad has one set of function pointers per process.
GlContext* g_loadedFor = nullptr;
// The context that is being loaded. Global, because glad's callback has no user pointer with every generator
// option.
GlContext* g_loading = nullptr;

std::string glString(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

struct Attempt {
    std::string name;
    std::unique_ptr<GlContext> (*open)(int device);
    int device;
};

std::unique_ptr<GlContext> openOsmesa(int) {
    return createOsmesaContext();
}

/// The contexts to try, in order.
std::vector<Attempt> attempts(const GlOptions& options) {
    std::vector<Attempt> list;
    if (options.backend != GlBackend::Osmesa) {
        if (options.device >= 0) {
            list.push_back({fmt::format("EGL device {}", options.device), createEglContext, options.device});
        } else {
            list.push_back({"EGL surfaceless", createEglContext, -1});
            for (int device = 0; device < eglDeviceCount(); ++device)
                list.push_back({fmt::format("EGL device {}", device), createEglContext, device});
        }
    }
    // OSMesa has no devices, so it is no alternative to a requested device number.
    if (options.backend == GlBackend::Osmesa || (options.backend == GlBackend::Auto && options.device < 0))
        list.push_back({"OSMesa", openOsmesa, -1});
    return list;
}

} // namespace

void GlContext::makeCurrent() {
    bind();
    if (g_loadedFor != this) loadFunctions();
}

void GlContext::release() {
    unbind();
}

void GlContext::loadFunctions() {
    g_loadedFor = nullptr;
    g_loading = this;
    const int version = gladLoadGL(addressInLoading);
    g_loading = nullptr;
    if (version == 0) {
        unbind();
        throw MachineError(backend_, "the OpenGL functions could not be loaded");
    }
    g_loadedFor = this;
}

GlContext::Function GlContext::addressInLoading(const char* name) {
    return g_loading->functionAddress(name);
}

void GlContext::forget() {
    if (g_loadedFor == this) g_loadedFor = nullptr;
}

void GlContext::describe() {
    makeCurrent();
    renderer_ = glString(GL_RENDERER);
    version_ = glString(GL_VERSION);
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    release();
    if (major < 4 || (major == 4 && minor < kOldestMinorVersion))
        throw MachineError(backend_, fmt::format("{} offers OpenGL {}", renderer_, version_),
                           fmt::format("4.{} core or newer", kOldestMinorVersion));
}

bool GlContext::softwareRasterizer() const {
    constexpr std::array<std::string_view, 3> kSoftware{"llvmpipe", "softpipe", "swrast"};
    return std::any_of(kSoftware.begin(), kSoftware.end(),
                       [this](std::string_view name) { return renderer_.find(name) != std::string::npos; });
}

void requireDriverSpace() {
    // Measured with llvmpipe of Mesa 22.3: 480 MB and for each thread its stack and a piece of the heap.
    constexpr double kLibraries = 512e6, kThread = 16e6;
    requireAddressSpace("OpenGL", kLibraries + kThread * std::thread::hardware_concurrency());
}

std::unique_ptr<GlContext> createGlContext(const GlOptions& options) {
    if (options.backend == GlBackend::Osmesa && options.device >= 0)
        throw InputError("--device", "OSMesa has no devices", "--gl egl or --gl auto");
    requireDriverSpace();
    std::string reasons;
    const std::vector<Attempt> list = attempts(options);
    for (const Attempt& attempt : list) {
        try {
            return attempt.open(attempt.device);
        } catch (const MachineError& error) {
            if (list.size() == 1) throw;
            reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", error.what());
        }
    }
    throw MachineError("OpenGL", "no context could be created, tried " + reasons, "OpenGL 4.1 core",
                       "on a machine without a GPU install libegl1 and libgl1-mesa-dri (llvmpipe)");
}

} // namespace plumbline
