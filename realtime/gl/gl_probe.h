// Tests which OpenGL contexts can be opened, for `plumbline doctor`.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// The result for one kind of context.
struct GlProbe {
    std::string backend; // "egl", "egl device 0", "osmesa"
    bool works = false;
    std::string detail; // renderer and version, or why it doesn't work
};
/// Tries all kinds of contexts.
std::vector<GlProbe> probeGl();

} // namespace plumbline
