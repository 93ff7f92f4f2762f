// The user's OpenGL options.
#pragma once

namespace plumbline {

enum class GlBackend { Auto, Egl, Osmesa };

struct GlOptions {
    GlBackend backend = GlBackend::Auto; // Auto: EGL, otherwise OSMesa
    int device = -1;                     // EGL device to open; -1 = surfaceless, or the first that works
    double timingBudgetMs = 1000;        // for timing each technique; 0: drawn once, cold
};

} // namespace plumbline
