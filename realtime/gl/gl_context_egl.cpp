// Off-screen EGL: Mesa's surfaceless platform, or a device of EGL_EXT_device_enumeration. libEGL is loaded at
// run time from the machine's installation, because it belongs to the GPU's driver.
#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_library.h"
#include "scenes/core/error.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <vector>

namespace plumbline {
namespace {

/// The functions of libEGL used here.
struct Egl {
    GlLibrary library{"egl", std::array{"libEGL.so.1"},
                      "install libegl1, and libgl1-mesa-dri or the driver of your GPU"};
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglChooseConfig) chooseConfig = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglCreatePbufferSurface) createPbufferSurface = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglDestroySurface) destroySurface = nullptr;
    decltype(&eglGetError) getError = nullptr;
    decltype(&eglGetProcAddress) getProcAddress = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    decltype(&eglQueryString) queryString = nullptr;

    Egl() {
        library.find("eglBindAPI", bindApi);
        library.find("eglChooseConfig", chooseConfig);
        library.find("eglCreateContext", createContext);
        library.find("eglCreatePbufferSurface", createPbufferSurface);
        library.find("eglDestroyContext", destroyContext);
        library.find("eglDestroySurface", destroySurface);
        library.find("eglGetError", getError);
        library.find("eglGetProcAddress", getProcAddress);
        library.find("eglInitialize", initialize);
        library.find("eglMakeCurrent", makeCurrent);
        library.find("eglQueryString", queryString);
    }
};

/// Throws MachineError where there is no libEGL.
const Egl& egl() {
    static const Egl functions;
    return functions;
}

std::string eglErrorText() {
    const EGLint code = egl().getError();
    switch (code) {
    case EGL_SUCCESS:
        return "no reason given";
    case EGL_NOT_INITIALIZED:
        return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
        return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
        return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
        return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
        return "EGL_BAD_CONFIG";
    case EGL_BAD_CONTEXT:
        return "EGL_BAD_CONTEXT";
    case EGL_BAD_DISPLAY:
        return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
        return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
        return "EGL_BAD_PARAMETER";
    case EGL_CONTEXT_LOST:
        return "EGL_CONTEXT_LOST";
    default:
        return fmt::format("EGL error {:#x}", static_cast<unsigned>(code));
    }
}

bool hasExtension(const char* list, std::string_view name) {
    std::string_view rest = list ? list : "";
    while (!rest.empty()) {
        const size_t end = rest.find(' ');
        if (rest.substr(0, end) == name) return true;
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }
    return false;
}

template <class Pointer>
Pointer eglFunction(const char* name) {
    return reinterpret_cast<Pointer>(egl().getProcAddress(name));
}

std::vector<EGLDeviceEXT> eglDevices() {
    const char* clientExtensions = egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasExtension(clientExtensions, "EGL_EXT_device_enumeration") &&
        !hasExtension(clientExtensions, "EGL_EXT_device_base"))
        return {};
    const auto queryDevices = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (!queryDevices || !queryDevices(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
    if (!queryDevices(count, devices.data(), &count)) return {};
    devices.resize(static_cast<size_t>(count));
    return devices;
}

/// EGL has one display per platform and device for the whole process. It stays initialized, because
/// eglTerminate would terminate it for all other contexts and unload the driver, including its threads and
/// statics.
EGLDisplay openDisplay(int device, const std::string& backend) {
    const auto getPlatformDisplay = eglFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const char* clientExtensions = egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!getPlatformDisplay || !hasExtension(clientExtensions, "EGL_EXT_platform_base"))
        throw MachineError(backend, "EGL finds no driver (it has no EGL_EXT_platform_base)");
    EGLDisplay display = EGL_NO_DISPLAY;
    if (device < 0) {
        if (!hasExtension(clientExtensions, "EGL_MESA_platform_surfaceless"))
            throw MachineError(backend, "EGL has no EGL_MESA_platform_surfaceless");
        display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    } else {
        const std::vector<EGLDeviceEXT> devices = eglDevices();
        if (static_cast<size_t>(device) >= devices.size())
            throw MachineError(backend,
                               fmt::format("is not one of the {} devices that EGL lists", devices.size()),
                               devices.empty() ? "" : fmt::format("at most {}", devices.size() - 1));
        display = getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(device)], nullptr);
    }
    if (display == EGL_NO_DISPLAY) throw MachineError(backend, "no EGL display: " + eglErrorText());
    EGLint major = 0, minor = 0;
    if (!egl().initialize(display, &major, &minor))
        throw MachineError(backend, "eglInitialize failed: " + eglErrorText());
    return display;
}

class EglContext final : public GlContext {
  public:
    EglContext(int device, const std::string& backend)
        : GlContext(backend), display_(openDisplay(device, backend)) {
        try {
            create();
            describe();
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~EglContext() override { destroy(); }

  protected:
    void bind() override {
        if (!egl().bindApi(EGL_OPENGL_API) || !egl().makeCurrent(display_, surface_, surface_, context_))
            throw MachineError(backend(), "eglMakeCurrent failed: " + eglErrorText());
    }
    void unbind() override { egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    Function functionAddress(const char* name) const override { return egl().getProcAddress(name); }

  private:
    void create() {
        if (!egl().bindApi(EGL_OPENGL_API))
            throw MachineError(backend(), "this EGL has no desktop OpenGL: " + eglErrorText());
        const bool surfaceless =
            hasExtension(egl().queryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context");
        const EGLConfig config = chooseConfig(surfaceless ? 0 : EGL_PBUFFER_BIT);
        if (!surfaceless) {
            const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = egl().createPbufferSurface(display_, config, size);
            if (surface_ == EGL_NO_SURFACE)
                throw MachineError(backend(), "no pbuffer surface: " + eglErrorText());
        }
        for (int minor = kNewestMinorVersion; minor >= kOldestMinorVersion; --minor) {
            const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                         4,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         minor,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
            context_ = egl().createContext(display_, config, EGL_NO_CONTEXT, attributes);
            if (context_ != EGL_NO_CONTEXT) return;
        }
        throw MachineError(
            backend(), fmt::format("no OpenGL 4.{} core context: {}", kOldestMinorVersion, eglErrorText()));
    }

    EGLConfig chooseConfig(EGLint surfaceType) const {
        const EGLint attributes[] = {EGL_SURFACE_TYPE, surfaceType, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                     EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!egl().chooseConfig(display_, attributes, &config, 1, &count) || count < 1)
            throw MachineError(backend(), "no EGL configuration with desktop OpenGL");
        return config;
    }

    void destroy() {
        forget();
        if (context_ != EGL_NO_CONTEXT) egl().destroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE) egl().destroySurface(display_, surface_);
        context_ = EGL_NO_CONTEXT;
        surface_ = EGL_NO_SURFACE;
    }

    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

} // namespace

int eglDeviceCount() {
    try {
        return static_cast<int>(eglDevices().size());
    } catch (const MachineError&) { // no libEGL, which createEglContext() reports
        return 0;
    }
}

std::unique_ptr<GlContext> createEglContext(int device) {
    return std::make_unique<EglContext>(device, device < 0 ? "egl" : fmt::format("egl device {}", device));
}

} // namespace plumbline
