// A library of the GL stack, opened when a context is asked for: the program starts, and does all that needs
// no OpenGL, on machines without it.
#pragma once

#include <span>
#include <string>

namespace plumbline {

/// A shared library that stays open to the end of the program: drivers' threads and statics don't survive
/// unloading.
class GlLibrary {
  public:
    /// Opens the first of `names` there is, privately. Throws MachineError that begins with `backend`.
    GlLibrary(std::string backend, std::span<const char* const> names, std::string_view hint);

    /// Points `function` at the function of that name. Throws MachineError where the library lacks it.
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
