#include "gl_objects.h"

#include "../scenes/error.h"

#include <fmt/format.h>

#include <fstream>

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

/// Bytes the system could still give, 0 if it doesn't say (Linux: MemAvailable of /proc/meminfo, in KiB).
double availableBytes() {
    std::ifstream file("/proc/meminfo");
    std::string key, unit;
    double kibibytes = 0;
    while (file >> key >> kibibytes) {
        std::getline(file, unit);
        if (key == "MemAvailable:") return kibibytes * 1024;
    }
    return 0;
}

} // namespace

void checkGl(const std::string& doing) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR) return;
    clearGlErrors();
    throw MachineError("OpenGL", fmt::format("{}: {}", doing, errorName(code)));
}

void clearGlErrors() {
    // A lost context reports errors for ever: no more than there are kinds of error.
    for (int i = 0; i < 8 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

void checkMemory(const std::string& doing, double bytes) {
    const double available = availableBytes();
    if (available > 0 && bytes > available)
        throw MachineError("memory", fmt::format("{} needs {:.1f} GB, {:.1f} GB are free", doing, bytes / 1e9,
                                                 available / 1e9));
}

} // namespace plumbline
