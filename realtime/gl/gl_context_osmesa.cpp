// OSMesa, Mesa's off-screen library. It is loaded at run time with local symbols, because it exports every
// gl* symbol; and it must be optional, because Mesa removed it in version 25.1.
#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_library.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <array>

namespace plumbline {
namespace {

// The part of OSMesa's interface used here (Mesa 22.3, GL/osmesa.h). Declared here because that header
// includes GL/gl.h, which conflicts with glad, and so that the build doesn't require the library.
using OsMesaContext = struct osmesa_context*;
constexpr int kOsMesaFormat = 0x22, kOsMesaRgba = 0x1908, kOsMesaProfile = 0x33, kOsMesaCoreProfile = 0x34,
              kOsMesaMajorVersion = 0x36, kOsMesaMinorVersion = 0x37;
constexpr unsigned kGlUnsignedByte = 0x1401;

struct OsMesa {
    GlLibrary library{"osmesa", std::array{"libOSMesa.so.8", "libOSMesa.so.6"}, "install libosmesa6"};
    OsMesaContext (*createContextAttribs)(const int*, OsMesaContext) = nullptr; // Mesa 12 or newer
    void (*destroyContext)(OsMesaContext) = nullptr;
    unsigned char (*makeCurrent)(OsMesaContext, void*, unsigned, int, int) = nullptr;
    void (*(*getProcAddress)(const char*))() = nullptr;

    OsMesa() {
        library.find("OSMesaCreateContextAttribs", createContextAttribs);
        library.find("OSMesaDestroyContext", destroyContext);
        library.find("OSMesaMakeCurrent", makeCurrent);
        library.find("OSMesaGetProcAddress", getProcAddress);
    }
};

const OsMesa& osMesa() {
    static const OsMesa mesa;
    return mesa;
}

class OsmesaContext final : public GlContext {
  public:
    OsmesaContext() : GlContext("osmesa"), mesa_(osMesa()) {
        for (int minor = kNewestMinorVersion; minor >= kOldestMinorVersion && !context_; --minor) {
            const int attributes[] = {kOsMesaFormat,
                                      kOsMesaRgba,
                                      kOsMesaProfile,
                                      kOsMesaCoreProfile,
                                      kOsMesaMajorVersion,
                                      4,
                                      kOsMesaMinorVersion,
                                      minor,
                                      0};
            context_ = mesa_.createContextAttribs(attributes, nullptr);
        }
        if (!context_)
            throw MachineError("osmesa", fmt::format("no OpenGL 4.{} core context", kOldestMinorVersion));
        try {
            describe();
        } catch (...) {
            destroy();
            throw;
        }
    }
    ~OsmesaContext() override { destroy(); }

  protected:
    void bind() override {
        if (!mesa_.makeCurrent(context_, buffer_.data(), kGlUnsignedByte, 1, 1))
            throw MachineError(backend(), "OSMesaMakeCurrent failed");
    }
    void unbind() override { mesa_.makeCurrent(nullptr, nullptr, kGlUnsignedByte, 0, 0); }
    Function functionAddress(const char* name) const override { return mesa_.getProcAddress(name); }

  private:
    void destroy() {
        forget();
        if (context_) mesa_.destroyContext(context_);
        context_ = nullptr;
    }

    const OsMesa& mesa_;
    OsMesaContext context_ = nullptr;
    std::array<unsigned char, 4>
        buffer_{}; // OSMesa requires an image buffer; we render to framebuffer objects
};

} // namespace

std::unique_ptr<GlContext> createOsmesaContext() {
    return std::make_unique<OsmesaContext>();
}

} // namespace plumbline
