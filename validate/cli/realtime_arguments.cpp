#include "validate/cli/realtime_arguments.h"

#include "validate/cli/option_values.h"
#include "validate/cli/parsed_option.h"

#include <fmt/format.h>

namespace plumbline {

void DrawMemoryArguments::addTo(CLI::App& command) {
    addParsed(
        command, "--draw-memory", bytes,
        [](const std::string& text) { return parseMemorySize("--draw-memory", text); },
        fmt::format("Limit of the process that draws, for example 2G (default: {:.0f} % of the free memory)",
                    100 * kMemoryShare))
        ->type_name("SIZE");
}

void RealtimeArguments::addTo(CLI::App& command) {
    constexpr int kLongestTimeLimitSeconds = 86400;
    command
        .add_option("--technique", techniques,
                    "SEARCH[@SURFACE][:key=value,…], SEARCH a name or a folder; may be repeated. Default: "
                    "all: every search on flat and quadric, linear_binary on the quadric's variants")
        ->type_name("NAME|DIR")
        ->allow_extra_args(false);
    addParsed<std::vector<std::string>>(command, "--set", settings, parseSettings,
                                        "A parameter of all techniques; may be repeated")
        ->type_name("key=value")
        ->allow_extra_args(false);
    gl.addTo(command);
    command
        .add_option("--time-limit", timeLimitSeconds,
                    fmt::format("Limit in seconds for compiling and drawing a technique (default: {})",
                                kDefaultTimeLimitSeconds))
        ->check(CLI::Range(1, kLongestTimeLimitSeconds))
        ->type_name("SECONDS");
    drawMemory.addTo(command);
}

} // namespace plumbline
