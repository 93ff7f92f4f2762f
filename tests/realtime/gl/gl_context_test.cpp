// Contexts of both backends in one process.
#include "realtime/gl/gl_probe.h"
#include "tests/errors.h"
#include "tests/realtime/gl_fixture.h"

#include <glad/gl.h>

#include <cstdlib>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(GlContext, OpenContext_ReportsBackendAndRenderer) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto context = createGlContext({});
    EXPECT_FALSE(context->backend().empty());
    EXPECT_FALSE(context->renderer().empty());
    EXPECT_THAT(context->version(), testing::MatchesRegex("4\\.[1-9].*"));
}

/// Clears a pixel and reads it back, to check that glad's functions belong to the current context.
void drawPixel(GlContext& context) {
    const CurrentContext current(context);
    GLuint texture = 0, framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    const float color[] = {1.25f, -2, 3, 4};
    glClearBufferfv(GL_COLOR, 0, color);
    float pixel[4] = {};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel);
    EXPECT_THAT(pixel, testing::ElementsAreArray(color));
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

TEST(GlContext, BothBackends_AlternateInOneProcess) {
    PLUMBLINE_NEEDS_GL(GlBackend::Egl);
    PLUMBLINE_NEEDS_GL(GlBackend::Osmesa);
    const auto egl = createGlContext({GlBackend::Egl, -1}), osmesa = createGlContext({GlBackend::Osmesa, -1});
    EXPECT_THAT(egl->backend(), HasSubstr("egl"));
    EXPECT_EQ(osmesa->backend(), "osmesa");
    for (int i = 0; i < 3; ++i) {
        drawPixel(*egl);
        drawPixel(*osmesa);
    }
}

TEST(GlContext, TwoEglContexts_OutliveEachOther) {
    PLUMBLINE_NEEDS_GL(GlBackend::Egl);
    auto first = createGlContext({GlBackend::Egl, -1});
    const auto second = createGlContext({GlBackend::Egl, -1});
    first.reset(); // must not terminate the shared display
    drawPixel(*second);
}

/// Sets an environment variable for one scope.
class ScopedVariable {
  public:
    ScopedVariable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
    ~ScopedVariable() { unsetenv(name_); }

  private:
    const char* name_;
};

TEST(GlContext, MissingBackend_ErrorListsAttempts) {
    EXPECT_THAT(messageOf<MachineError>([] {
                    createGlContext({GlBackend::Egl, 99});
                }),
                StartsWith("egl device 99: "));
    EXPECT_THROW(createGlContext({GlBackend::Osmesa, 0}), InputError);
}

TEST(GlContextWithoutAnyDriver, NoDriver_ErrorListsEveryBackend) {
    // Mesa's loader is directed to a folder without drivers, so every EGL context fails. GLVND reads its
    // variable on first use, so this needs a process that hasn't used EGL yet: a separate suite.
    const ScopedVariable noVendor("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null");
    const std::string message = messageOf<MachineError>([] { createGlContext({GlBackend::Egl, -1}); });
    if (message.empty()) {
        GTEST_SKIP() << "EGL has already loaded its drivers";
    }
    EXPECT_THAT(message, StartsWith("egl: EGL finds no driver"));
    // Auto falls back to OSMesa if it is available.
    if (missingGl(GlBackend::Osmesa).empty()) {
        EXPECT_EQ(createGlContext({})->backend(), "osmesa");
    } else {
        EXPECT_THAT(missingGl(), HasSubstr("egl: EGL finds no driver"));
    }
}

TEST(GlProbe, EveryBackend_HasRendererOrReason) {
    const std::vector<GlProbe> probes = probeGl();
    ASSERT_GE(probes.size(), 2u);
    EXPECT_EQ(probes.front().backend, "egl");
    EXPECT_EQ(probes.back().backend, "osmesa");
    for (const GlProbe& probe : probes)
        EXPECT_FALSE(probe.detail.empty()) << probe.backend;
}

} // namespace
} // namespace plumbline
