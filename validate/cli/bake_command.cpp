#include "realtime/bake/bake_cache.h"
#include "realtime/bake/baked_map_picture.h"
#include "realtime/bake/cone_check.h"
#include "realtime/bake/cone_map.h"
#include "scenes/core/error.h"
#include "scenes/core/program_name.h"
#include "scenes/maps/map_file.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/option_values.h"
#include "validate/cli/parsed_option.h"
#include "validate/cli/progress.h"
#include "validate/cli/thread_arguments.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

constexpr uint64_t kDefaultCheckRays = 1'000'000;

struct Arguments {
    std::string map; // a picture's path, or SCENE#NAME: a map of a scene
    const BakeKind* kind = nullptr;
    // These four stay texts until MAP and the kind say which of them are wanted: refusals quote them.
    std::optional<std::string> stores, wrap;    // of a picture: "depth" or "height"; "repeat,clamp"
    std::optional<std::string> depth, tileSize; // world units; "2,1.5"
    std::optional<int> slices;
    std::optional<std::filesystem::path> output; // a picture
    bool check = false;                          // of a cone map: rays that skip over the relief
    std::optional<uint64_t> rays;                // so many
    ThreadArguments threads;
};

std::shared_ptr<const HeightMap> readPicture(const Arguments& arguments) {
    if (!arguments.stores)
        throw InputError("--stores", "is missing", "depth or height, the meaning of the image's values");
    const std::string stores = parseChoice("--stores", *arguments.stores, {"depth", "height"});
    const auto [wrapS, wrapT] = parseWraps(arguments.wrap.value_or("repeat,repeat"));
    return std::make_shared<const HeightMap>(
        readHeightMap(arguments.map, stores == "depth" ? Stores::Depth : Stores::Height, wrapS, wrapT));
}

/// A file of that name is a picture, whatever its name has in it; else SCENE#NAME.
std::shared_ptr<const HeightMap> readMap(const Arguments& arguments) {
    std::error_code ignored;
    const bool isFile = std::filesystem::is_regular_file(arguments.map, ignored);
    if (isFile && std::filesystem::path(arguments.map).extension() == ".toml")
        throw InputError(arguments.map, "is a scene", "one of its height maps, as SCENE.toml#NAME");
    const size_t hash = arguments.map.rfind('#');
    if (isFile || hash == std::string::npos) return readPicture(arguments);
    for (const auto& [option, value] :
         {std::pair("--stores", &arguments.stores), std::pair("--wrap", &arguments.wrap)})
        if (*value)
            throw InputError(option, fmt::format("found '{}' with a scene's map", **value), "nothing",
                             "the scene file defines both for its maps");
    return readSceneMap(findScene(arguments.map.substr(0, hash)), arguments.map.substr(hash + 1));
}

BakeScale parseScale(const Arguments& arguments, const BakeKind& kind) {
    BakeScale scale;
    for (const auto& [option, value] :
         {std::pair("--depth", arguments.depth), std::pair("--tile-size", arguments.tileSize)}) {
        if (value && !kind.needsScale)
            throw InputError(option, fmt::format("found '{}'", *value),
                             fmt::format("no scale for kind '{}', which doesn't depend on one", kind.name));
        if (!value && kind.needsScale)
            throw InputError(option, "is missing",
                             fmt::format("--depth D and --tile-size SX,SY, world units: kind '{}' depends on "
                                         "the scale",
                                         kind.name));
    }
    if (!kind.needsScale) return scale;
    const auto [s, t] = parsePair("--tile-size", *arguments.tileSize, "2,1.5");
    return {parseLength("--tile-size", s), parseLength("--tile-size", t),
            parseLength("--depth", *arguments.depth)};
}

BakeRequest parseRequest(const Arguments& arguments) {
    const BakeKind& kind = *arguments.kind;
    BakeRequest request;
    request.kind = kind.name;
    request.scale = parseScale(arguments, kind);
    if (arguments.slices && !kind.takesSlices)
        throw InputError("--slices", fmt::format("found {}", *arguments.slices),
                         fmt::format("none for kind '{}', which has no slices", kind.name));
    request.slices = arguments.slices.value_or(request.slices);
    return request;
}

std::string counted(size_t number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

void printSummary(const BakeOutcome& outcome) {
    const BakedMap& map = outcome.map;
    fmt::print("{}: {} x {}, {}, {}, {}, {} bytes; {:.1f} ms, {}: {}\n", map.kind, map.levels[0].width,
               map.levels[0].height, counted(static_cast<size_t>(map.slices), "slice"),
               counted(static_cast<size_t>(map.channels), "channel"), counted(map.levels.size(), "level"),
               outcome.bytes, outcome.ms, outcome.fromCache ? "from the cache" : "made now",
               outcome.file.empty() ? "not kept" : outcome.file.string());
}

std::map<std::string, std::string> pictureMetadata(const HeightMap& map, const BakeRequest& request) {
    const auto name = [](Wrap wrap) { return wrap == Wrap::Repeat ? "repeat" : "clamp"; };
    std::map<std::string, std::string> metadata{
        {"program", programName()},
        {"map", map.name()},
        {"map_wrap", fmt::format("{} {}", name(map.wrapS()), name(map.wrapT()))}};
    if (bakeKind(request.kind).needsScale) {
        metadata["tile_size"] = fmt::format("{} {}", request.scale.s, request.scale.t);
        metadata["relief_depth"] = fmt::format("{}", request.scale.depth);
    }
    return metadata;
}

/// Before anything is made: --check of what can't be checked.
void requireCheckable(const Arguments& arguments) {
    if (arguments.rays && !arguments.check)
        throw InputError("--rays", fmt::format("found {} without --check", *arguments.rays),
                         "both, or neither");
    if (arguments.check && !isConeKind(arguments.kind->name))
        throw InputError("--check", fmt::format("kind '{}' is not a cone map", arguments.kind->name),
                         "a kind that begins with cone_step");
}

/// One line for each kind of lookup: the number of rays that skipped over relief, and their largest depth in
/// it.
void printConeCheck(const HeightMap& map, const BakedMap& cones, uint64_t rays) {
    constexpr uint64_t kSeed = 1;
    const bool relaxed = coneRule(cones.kind).relaxed;
    fmt::print("{:<12} {:>10} {:>10} {:>10}", "lookup", "rays", "pierced", "skipping");
    const char* const heads[] = {"<= 1e-5", "<= 1/1024", "<= 1/255", "<= 0.05", "more"};
    static_assert(std::size(heads) == ConeCheck::kDepths.size());
    for (const char* head : heads)
        fmt::print(" {:>10}", head);
    fmt::print(" {:>10} {:>10}\n", "deepest", "steps");
    for (const auto& [name, lookup] :
         {std::pair("cell", ConeLookup::Cell), std::pair("min_of_four", ConeLookup::MinOfFour),
          std::pair("bilinear", ConeLookup::Bilinear), std::pair("nearest", ConeLookup::Nearest)}) {
        const ConeCheck check = checkCones(map, cones, lookup, relaxed, rays, kSeed);
        fmt::print("{:<12} {:>10} {:>10} {:>10}", name, check.rays, check.pierced, check.overshootingRays);
        for (const uint64_t count : check.overshootsByDepth)
            fmt::print(" {:>10}", count);
        fmt::print(" {:>10.3g} {:>10.2f}\n", check.deepest, check.meanSteps());
    }
    fmt::print("skips by depth below the surface, in relief depths; steps: mean until within 1/1024 of it\n");
}

int runBake(const Arguments& arguments) {
    const ThreadLimit limit(arguments.threads.threads);
    const BakeRequest request = parseRequest(arguments);
    requireCheckable(arguments);
    std::optional<FileClaim> claim;
    if (arguments.output)
        claim.emplace(
            claimFile(*arguments.output, {arguments.map, arguments.map.substr(0, arguments.map.rfind('#'))}));
    Progress progress;
    progress.step("reading the map");
    const std::shared_ptr<const HeightMap> map = readMap(arguments);
    progress.step("baking");
    const BakeOutcome outcome = bakeCached(*map, request);
    if (!outcome.warning.empty()) printWarnings({outcome.warning});
    if (arguments.output) {
        progress.step("writing");
        writeBakedPicture(*arguments.output, outcome.map, pictureMetadata(*map, request));
    }
    printSummary(outcome);
    if (arguments.output) fmt::print("{}\n", arguments.output->string());
    if (arguments.check) {
        progress.step("checking");
        printConeCheck(*map, outcome.map, arguments.rays.value_or(kDefaultCheckRays));
    }
    return kExitDone;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("MAP", arguments->map, "An image, or SCENE#NAME: a height map of a scene")->required();
    addParsed(
        command, "--kind", arguments->kind, [](const std::string& text) { return &bakeKind(text); },
        "Kind of the map; 'plumbline list bakes' describes them")
        ->required()
        ->type_name("K");
    command.add_option("-o", arguments->output, "Also write it as an image")->type_name("FILE.exr");
    command.add_option("--stores", arguments->stores, "Meaning of the image's values")
        ->type_name("depth|height");
    command
        .add_option("--wrap", arguments->wrap,
                    "Wrap mode along s and t: repeat or clamp (default: repeat,repeat)")
        ->type_name("S,T");
    command
        .add_option("--depth", arguments->depth, "Relief depth in world units, for kinds that need a scale")
        ->type_name("D");
    command
        .add_option("--tile-size", arguments->tileSize,
                    "Width and height of the map in world units, likewise")
        ->type_name("SX,SY");
    command
        .add_option("--slices", arguments->slices,
                    fmt::format("Slices of a distance field (default: {})", BakeRequest().slices))
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command.add_flag("--check", arguments->check,
                     "Of a cone map: step random rays with it and count those that skip over the relief");
    command
        .add_option("--rays", arguments->rays,
                    fmt::format("Number of rays, with --check (default: {})", kDefaultCheckRays))
        ->check(CLI::Range(uint64_t(1), uint64_t(1) << 40))
        ->type_name("N");
    arguments->threads.addTo(command);
    return [arguments] { return runBake(*arguments); };
}

} // namespace

Command bakeCommand() {
    return {"bake", "Bake a map that techniques use; cached by content", addOptions};
}

} // namespace plumbline
