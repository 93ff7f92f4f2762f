// Which OpenGL contexts can be opened here; for `plumbline doctor`.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// One way to a context.
struct GlProbe {
    std::string backend; // "egl", "egl device 0", "osmesa"
    bool works = false;
    std::string detail; // renderer and version, or why it doesn't work
};
/// Tries them all.
std::vector<GlProbe> probeGl();

} // namespace plumbline
