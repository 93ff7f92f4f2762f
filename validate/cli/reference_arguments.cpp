#include "validate/cli/reference_arguments.h"

#include "validate/cli/shared.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline {

void ReferenceArguments::addTo(CLI::App& command, const char* bases) {
    command
        .add_option(
            "--base", base,
            "Surface the reference displaces: the limit surface or the proxy's polygons (default: limit)")
        ->type_name(bases);
    command
        .add_option(
            "--error-px", errorPx,
            fmt::format("Aim for the 99th percentile of the reference's own error, pixels (default: {})",
                        ReferenceOptions().errorPx))
        ->type_name("E");
    command.add_option("--rate", rate, "Segments per control edge, a power of two (default: automatic)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command
        .add_option("--memory", memory,
                    "Memory for micro-triangles, for example 256M or 2G (default: half of the free memory)")
        ->type_name("SIZE");
}

ReferenceOptions ReferenceArguments::options() const {
    ReferenceOptions options;
    options.rate = rate;
    if (errorPx) options.errorPx = parseErrorPx(*errorPx);
    if (memory) options.memoryBytes = parseMemorySize(*memory);
    return options;
}

} // namespace plumbline
