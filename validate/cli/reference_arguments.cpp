#include "validate/cli/reference_arguments.h"

#include "validate/cli/option_values.h"
#include "validate/cli/parsed_option.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

BaseChoice parseBase(const std::string& text, const std::vector<std::string>& choices) {
    const std::string base = parseChoice("--base", text, choices);
    return base == "limit" ? BaseChoice::Limit : base == "proxy" ? BaseChoice::Proxy : BaseChoice::Both;
}

} // namespace

void ReferenceArguments::addTo(CLI::App& command, bool bothIsAChoice) {
    std::vector<std::string> bases{"limit", "proxy"};
    if (bothIsAChoice) bases.emplace_back("both");
    addParsed(
        command, "--base", base, [bases](const std::string& text) { return parseBase(text, bases); },
        "Surface the reference displaces: the limit surface or the proxy's polygons (default: limit)")
        ->type_name(fmt::format("{}", fmt::join(bases, "|")));
    addParsed(command, "--error-px", options.errorPx, parseErrorPx,
              fmt::format("Aim for the 99th percentile of the reference's own error, pixels (default: {})",
                          ReferenceOptions().errorPx))
        ->type_name("E");
    command
        .add_option("--rate", options.rate, "Segments per control edge, a power of two (default: automatic)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    addParsed(
        command, "--memory", options.memoryBytes,
        [](const std::string& text) { return parseMemorySize("--memory", text); },
        "Memory for micro-triangles, for example 256M or 2G (default: half of the free memory)")
        ->type_name("SIZE");
}

} // namespace plumbline
