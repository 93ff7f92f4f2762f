#include "realtime/gl/gl_library.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace plumbline {

GlLibrary::GlLibrary(std::string backend, std::span<const char* const> names, std::string_view hint)
    : backend_(std::move(backend)) {
    std::string reasons;
    for (const char* name : names) {
        name_ = name;
        library_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library_) return;
        reasons += fmt::format("{}{}", reasons.empty() ? "" : ", ", dlerror());
    }
    throw MachineError(backend_, reasons, "", hint);
}

void* GlLibrary::address(const char* name) const {
    void* found = dlsym(library_, name);
    if (!found) throw MachineError(backend_, fmt::format("{} has no {}", name_, name));
    return found;
}

} // namespace plumbline
