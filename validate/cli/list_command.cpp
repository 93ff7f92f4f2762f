#include "realtime/bake/bake.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/harness_parameters.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/parsed_option.h"
#include "validate/metrics/metric_registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace plumbline {
namespace {

void listScenes() {
    const auto scenes = libraryScenes();
    size_t width = 0;
    for (const LibraryScene& scene : scenes)
        width = std::max(width, scene.name.size());
    for (const LibraryScene& scene : scenes)
        fmt::print("{:<{}}  {}\n", scene.name, width, printable(scene.purpose));
}

void listMetrics() {
    for (const MetricInfo& metric : metricTable())
        fmt::print("{}", describe(metric));
}

void listBakes() {
    for (const BakeKind& kind : bakeKinds()) {
        fmt::print("{}: {}\n    source: {}\n", kind.name, kind.meaning, kind.source);
        fmt::print("    channels: {}\n    slices: {}\n", kind.channels, kind.slices);
        if (kind.needsScale) fmt::print("    needs a scale: --depth and --tile-size\n");
    }
}

void printParameters(const std::vector<Parameter>& parameters) {
    for (const Parameter& parameter : parameters)
        fmt::print("    {} = {}  {} {}{}: {}\n", parameter.name, parameter.format(parameter.defaultValue),
                   parameter.typeName(), parameter.rangeText(),
                   parameter.unit.empty() ? "" : ", " + printable(parameter.unit), parameter.meaning);
}

void listAllSurfaces() {
    for (const Manifest& surface : listSurfaces()) {
        fmt::print("{}: {}\n    source: {}\n", surface.name, surface.title, surface.citation);
        if (!surface.variantOf.empty()) fmt::print("    variant of: {}\n", surface.variantOf);
        if (!surface.offers.empty()) fmt::print("    offers: {}\n", fmt::join(surface.offers, ", "));
        fmt::print("    shadows: {}\n", fmt::join(offeredShadows(surface), ", "));
        if (!surface.inputs.empty()) fmt::print("    inputs: {}\n", fmt::join(surface.inputs, ", "));
        printParameters(surface.parameters);
        for (const std::string& limit : surface.limits)
            fmt::print("    limit: {}\n", printable(limit));
    }
}

void listAllTechniques() {
    const std::vector<Manifest> library = listSurfaces();
    for (const Manifest& technique : listTechniques()) {
        fmt::print("{}: {}\n", technique.name, technique.title);
        if (!technique.citation.empty()) fmt::print("    source: {}\n", technique.citation);
        if (!technique.needs.empty()) fmt::print("    needs: {}\n", fmt::join(technique.needs, ", "));
        if (const std::vector<std::string> surfaces = surfacesFor(technique, library); !surfaces.empty())
            fmt::print("    surfaces: {}\n", fmt::join(surfaces, ", "));
        if (const std::vector<std::string> shadows = offeredShadows(technique); !shadows.empty())
            fmt::print("    shadows: {}\n", fmt::join(shadows, ", "));
        if (!technique.inputs.empty()) fmt::print("    inputs: {}\n", fmt::join(technique.inputs, ", "));
        printParameters(technique.parameters);
        for (const std::string& limit : technique.limits)
            fmt::print("    limit: {}\n", printable(limit));
    }
}

/// Prints a list.
using PrintList = void (*)();

PrintList parseWhat(const std::string& what) {
    static const std::pair<std::string, PrintList> lists[] = {{"scenes", listScenes},
                                                              {"techniques", listAllTechniques},
                                                              {"surfaces", listAllSurfaces},
                                                              {"metrics", listMetrics},
                                                              {"bakes", listBakes}};
    std::vector<std::string> choices;
    for (const auto& [name, print] : lists) {
        if (name == what) return print;
        choices.push_back(name);
    }
    throw InputError("list", fmt::format("found '{}'", what), listOf(choices), didYouMean(what, choices));
}

CommandRun addOptions(CLI::App& command) {
    const auto print = std::make_shared<PrintList>();
    addParsed(command, "WHAT", *print, parseWhat, "scenes, techniques, surfaces, metrics or bakes")
        ->required();
    return [print] {
        (*print)();
        return kExitDone;
    };
}

} // namespace

Command listCommand() {
    return {"list", "List scenes, techniques, surfaces, metrics or kinds of baked maps", addOptions};
}

} // namespace plumbline
