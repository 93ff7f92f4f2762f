// --gl and --device.
#pragma once

#include "realtime/gl/gl_options.h"

namespace CLI {
class App;
}

namespace plumbline {

struct GlArguments {
    GlOptions options;

    void addTo(CLI::App& command);
};

} // namespace plumbline
