#include "realtime/gl/gl_objects.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

std::string errorName(GLenum code) {
    switch (code) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "out of video memory";
    default:
        return fmt::format("GL error {:#x}", code);
    }
}

} // namespace

void checkGl(const std::string& doing) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR) return;
    clearGlErrors();
    throw MachineError("OpenGL", fmt::format("{}: {}", doing, errorName(code)));
}

void clearGlErrors() {
    // A lost context reports errors forever, so at most as many are read as there are kinds of errors.
    for (int i = 0; i < 8 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

} // namespace plumbline
