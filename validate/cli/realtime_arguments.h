// Options of techniques: --technique, --set, --gl, --device, --time-limit, --draw-memory.
#pragma once

#include "validate/cli/gl_arguments.h"
#include "validate/worker/technique_worker.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plumbline {

struct DrawMemoryArguments {
    uint64_t bytes = 0; // of the drawing process; 0: a share of what is free

    void addTo(CLI::App& command);
};

struct RealtimeArguments {
    std::vector<std::string> techniques; // texts: they are resolved together (chosen_techniques.h)
    Settings settings;                   // for all of them
    GlArguments gl;
    int timeLimitSeconds = kDefaultTimeLimitSeconds; // a technique
    DrawMemoryArguments drawMemory;

    void addTo(CLI::App& command);
};

} // namespace plumbline
