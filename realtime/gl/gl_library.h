// A library of the GL stack, loaded when a context is requested, so that the program also runs on machines
// without OpenGL for everything that doesn't need it.
#pragma once

#include <span>
#include <string>

namespace plumbline {

/// A shared library that is never unloaded, because drivers' threads and statics don't survive unloading.
class GlLibrary {
  public:
    /// Loads the first available library of `names` with local symbols. Throws MachineError that begins with
    /// `backend`.
    GlLibrary(std::string backend, std::span<const char* const> names, std::string_view hint);

    /// Sets `function` to the function of that name. Throws MachineError if the library lacks it.
    template <class Function>
    void find(const char* name, Function*& function) const {
        function = reinterpret_cast<Function*>(address(name));
    }

  private:
    void* address(const char* name) const;

    std::string backend_, name_;
    void* library_ = nullptr;
};

} // namespace plumbline
