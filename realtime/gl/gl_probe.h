// Tests which OpenGL contexts can be opened, for `plumbline doctor`, and whether this program was built
// with OpenGL at all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// The result for one kind of context.
struct GlProbe {
    std::string backend; // "egl", "egl device 0", "osmesa"
    bool works = false;
    std::string detail; // renderer and version, or why it doesn't work
};
/// Tries all kinds of contexts. Empty: this program was built without OpenGL.
std::vector<GlProbe> probeGl();

/// Before any work whose end is to be drawn: throws MachineError if this program was built without OpenGL.
/// `where`, `expected`, `hint`: of the message, as MachineError has them.
void requireGlBuild(std::string_view where, std::string_view expected = {}, std::string_view hint = {});

} // namespace plumbline
