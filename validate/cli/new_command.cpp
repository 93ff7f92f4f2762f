#include "scenes/core/error.h"
#include "scenes/core/replace_file.h"
#include "scenes/draft/scene_text.h"
#include "scenes/maps/map_file.h"
#include "scenes/mesh/obj_file.h"
#include "scenes/scene_file/scene_file.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/shared.h"
#include "validate/results/output_files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline {
namespace {

struct Arguments {
    std::filesystem::path mesh, height; // OBJ; a picture
    std::optional<std::string> depth, tile, scheme,
        wrap;                      // world units; "4,2"; of scene files; "repeat,clamp"
    std::string stores = "height"; // or "depth"
    std::filesystem::path output;  // the scene file
    bool force = false;            // also if it exists
};

Scheme parseScheme(const std::string& text) {
    const std::string scheme = parseChoice("--scheme", text, {"catmull-clark", "loop", "none"});
    return scheme == "loop" ? Scheme::Loop : scheme == "none" ? Scheme::None : Scheme::CatmullClark;
}

DraftWishes parseWishes(const Arguments& arguments) {
    DraftWishes wishes;
    if (arguments.scheme) wishes.scheme = parseScheme(*arguments.scheme);
    if (arguments.depth) wishes.depth = parseLength("--depth", *arguments.depth);
    if (arguments.tile) {
        const auto [s, t] = parsePair("--tile", *arguments.tile, "4,2");
        wishes.tile = Vec2(parseTile("--tile", s), parseTile("--tile", t));
    }
    return wishes;
}

/// As the scene file is to name `file`: its reader puts that behind its own folder and takes away "x/..", so
/// no link is followed here either.
std::filesystem::path relativeTo(const std::filesystem::path& scene, const std::filesystem::path& file) {
    const auto plain = [](const std::filesystem::path& path) {
        return std::filesystem::absolute(path).lexically_normal();
    };
    return plain(file).lexically_relative(plain(scene).parent_path());
}

void requireNewName(const Arguments& arguments) {
    if (arguments.output.extension() != ".toml")
        throw InputError(arguments.output.string(), "is not the name of a scene file", "FILE.toml");
    std::error_code ignored;
    if (!arguments.force && std::filesystem::exists(arguments.output, ignored))
        throw InputError(arguments.output.string(), "exists already", "a new name", "--force replaces it");
}

int runNew(const Arguments& arguments) {
    requireNewName(arguments);
    const DraftWishes wishes = parseWishes(arguments);
    const bool storesHeight = parseChoice("--stores", arguments.stores, {"height", "depth"}) == "height";
    const auto [wrapS, wrapT] = parseWraps(arguments.wrap);
    const ControlMesh mesh = readObj(arguments.mesh);
    const HeightMap map =
        readHeightMap(arguments.height, storesHeight ? Stores::Height : Stores::Depth, wrapS, wrapT);
    const std::string text =
        sceneText(draftScene(mesh, map, wishes), relativeTo(arguments.output, arguments.mesh),
                  relativeTo(arguments.output, arguments.height), map, storesHeight);
    const Scene scene = parseScene(arguments.output, text); // nothing is written that can't be read
    requireWritableFile(arguments.output, {arguments.mesh, arguments.height});
    replaceFile(arguments.output, text);
    printWarnings(scene.warnings);
    fmt::print("{}\nnext: plumbline validate {}\n", arguments.output.string(), arguments.output.string());
    return kExitDone;
}

CommandRun addOptions(CLI::App& command) {
    const auto arguments = std::make_shared<Arguments>();
    command.add_option("--mesh", arguments->mesh, "A mesh with texture coordinates")
        ->required()
        ->type_name("M.obj");
    command.add_option("--height", arguments->height, "The relief, a gray image")
        ->required()
        ->type_name("H.png");
    command.add_option("-o", arguments->output, "The scene file")->required()->type_name("SCENE.toml");
    command.add_option("--depth", arguments->depth, "Relief depth in world units (default: automatic)")
        ->type_name("D");
    command.add_option("--tile", arguments->tile, "Repeats of the map along u and v (default: automatic)")
        ->type_name("S,T");
    command.add_option("--scheme", arguments->scheme, "Subdivision scheme of the mesh (default: automatic)")
        ->type_name("catmull-clark|loop|none");
    command.add_option("--stores", arguments->stores, "Meaning of the image's values (default: height)")
        ->type_name("height|depth");
    command
        .add_option("--wrap", arguments->wrap,
                    "Wrap mode along s and t: repeat or clamp (default: repeat,repeat)")
        ->type_name("S,T");
    command.add_flag("--force", arguments->force, "Replace an existing scene file");
    return [arguments] { return runNew(*arguments); };
}

} // namespace

Command newCommand() {
    return {"new", "Write a first scene file for a mesh and a height map", addOptions};
}

} // namespace plumbline
