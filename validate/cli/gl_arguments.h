// --gl and --device.
#pragma once

#include "realtime/gl/gl_options.h"

#include <string>

namespace CLI {
class App;
}

namespace plumbline {

struct GlArguments {
    std::string backend = "auto"; // or "egl" or "osmesa"
    int device = -1;              // of EGL; -1: chosen

    void addTo(CLI::App& command);
    /// Throws InputError for a backend there isn't.
    GlOptions options() const;
};

} // namespace plumbline
