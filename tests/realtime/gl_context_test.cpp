// Contexts of both backends in one process.
#include "gl_fixture.h"

#include <glad/gl.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::HasSubstr;

TEST(GlContext, SaysWhatItIs) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const auto context = createGlContext({});
    EXPECT_FALSE(context->backend().empty());
    EXPECT_FALSE(context->renderer().empty());
    EXPECT_THAT(context->version(), testing::MatchesRegex("4\\.[1-9].*"));
}

/// Clears a pixel and reads it back: the functions glad holds belong to the context that is current.
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

TEST(GlContext, BothBackendsTakeTurnsInOneProcess) {
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

TEST(GlContext, TwoEglContextsOutliveEachOther) {
    PLUMBLINE_NEEDS_GL(GlBackend::Egl);
    auto first = createGlContext({GlBackend::Egl, -1});
    const auto second = createGlContext({GlBackend::Egl, -1});
    first.reset(); // must not terminate the display both share
    drawPixel(*second);
}

TEST(GlContext, WhatIsNotThereIsAMachineErrorThatSaysWhatWasTried) {
    try {
        createGlContext({GlBackend::Egl, 99});
        FAIL() << "device 99 exists";
    } catch (const MachineError& error) {
        EXPECT_THAT(error.what(), HasSubstr("egl device 99"));
        EXPECT_THAT(error.what(), HasSubstr("OpenGL: no context could be created"));
    }
    EXPECT_THROW(createGlContext({GlBackend::Osmesa, 0}), InputError);
}

TEST(GlProbe, ListsEveryWayInWithARendererOrAReason) {
    const std::vector<GlProbe> probes = probeGl();
    ASSERT_GE(probes.size(), 2u);
    EXPECT_EQ(probes.front().backend, "egl");
    EXPECT_EQ(probes.back().backend, "osmesa");
    for (const GlProbe& probe : probes)
        EXPECT_FALSE(probe.detail.empty()) << probe.backend;
}

} // namespace
} // namespace plumbline
