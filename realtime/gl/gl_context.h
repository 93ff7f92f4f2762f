// An off-screen OpenGL core context: one interface with two backends (EGL, OSMesa).
//
// OpenGL's functions (glad) are global and valid for one context at a time; makeCurrent() reloads them if
// another context was current before. Contexts of both backends may coexist in one process. They must be used
// from one thread, one at a time, never nested.
#pragma once

#include "realtime/gl/gl_options.h"

#include <memory>
#include <string>

namespace plumbline {

class GlContext {
  public:
    virtual ~GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Binds the context to this thread and loads glad's functions for it. Throws MachineError if the driver
    /// refuses.
    void makeCurrent();
    /// Unbinds it. A context must not be current when another is bound or when it is destroyed.
    void release();

    const std::string& backend() const { return backend_; }   // "egl", "egl device 0", "osmesa"
    const std::string& renderer() const { return renderer_; } // GL_RENDERER
    const std::string& version() const { return version_; }   // GL_VERSION
    /// Whether rendering runs on the CPU (llvmpipe, softpipe), where timer queries are meaningless.
    bool softwareRasterizer() const;

  protected:
    explicit GlContext(std::string backend) : backend_(std::move(backend)) {}
    /// Called by the constructors of backends: binds the context, loads the functions, reads the names,
    /// checks for 4.1 core and unbinds it.
    void describe();

    using Function = void (*)();
    virtual void bind() = 0;
    virtual void unbind() = 0;
    virtual Function functionAddress(const char* name) const = 0;
    /// Called by the destructors of backends, because glad's pointers must not outlive the context.
    void forget();

  private:
    void loadFunctions();
    static Function addressInLoading(const char* name);

    std::string backend_, renderer_, version_;
};

/// Scoped makeCurrent/release.
class CurrentContext {
  public:
    explicit CurrentContext(GlContext& context) : context_(context) { context_.makeCurrent(); }
    ~CurrentContext() { context_.release(); }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

  private:
    GlContext& context_;
};

/// Opens a context according to the options. Throws MachineError that lists what was tried and why it failed.
std::unique_ptr<GlContext> createGlContext(const GlOptions& options);

/// Context versions requested, best first: 4.5 down to 4.1, all core.
inline constexpr int kNewestMinorVersion = 5, kOldestMinorVersion = 1;

/// Throws MachineError if a limit leaves too little address space for a software driver.
void requireDriverSpace();

// The backends. Each throws MachineError that names what is missing.
/// `device` -1: the surfaceless platform; otherwise the EGL device of that number.
std::unique_ptr<GlContext> createEglContext(int device);
/// Number of EGL devices; 0 if EGL can't list them.
int eglDeviceCount();
std::unique_ptr<GlContext> createOsmesaContext();

} // namespace plumbline
