// What OpenGL a user asks for.
#pragma once

namespace plumbline {

enum class GlBackend { Auto, Egl, Osmesa };

struct GlOptions {
    GlBackend backend = GlBackend::Auto; // Auto: EGL, else OSMesa
    int device = -1;                     // EGL device to open; -1 = surfaceless, or the first that works
    double timingBudgetMs = 1000;        // spent on timing each technique; 0: it is drawn once, cold
};

} // namespace plumbline
