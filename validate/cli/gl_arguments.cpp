#include "validate/cli/gl_arguments.h"

#include "scenes/core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline {

void GlArguments::addTo(CLI::App& command) {
    command.add_option("--gl", backend, "auto, egl or osmesa")->type_name("BACKEND");
    command.add_option("--device", device, "EGL device")->check(CLI::Range(0, 1023))->type_name("N");
}

GlOptions GlArguments::options() const {
    GlOptions options;
    options.device = device;
    if (backend == "egl")
        options.backend = GlBackend::Egl;
    else if (backend == "osmesa")
        options.backend = GlBackend::Osmesa;
    else if (backend != "auto")
        throw InputError("--gl", fmt::format("found '{}'", backend), "auto, egl or osmesa");
    return options;
}

} // namespace plumbline
