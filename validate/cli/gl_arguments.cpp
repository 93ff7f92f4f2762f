#include "validate/cli/gl_arguments.h"

#include "scenes/core/error.h"
#include "validate/cli/parsed_option.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

GlBackend parseBackend(const std::string& text) {
    if (text == "auto") return GlBackend::Auto;
    if (text == "egl") return GlBackend::Egl;
    if (text == "osmesa") return GlBackend::Osmesa;
    throw InputError("--gl", fmt::format("found '{}'", text), "auto, egl or osmesa");
}

} // namespace

void GlArguments::addTo(CLI::App& command) {
    addParsed(command, "--gl", options.backend, parseBackend, "auto, egl or osmesa")->type_name("BACKEND");
    command.add_option("--device", options.device, "EGL device")->check(CLI::Range(0, 1023))->type_name("N");
}

} // namespace plumbline
