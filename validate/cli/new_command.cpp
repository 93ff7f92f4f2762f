#include "scenes/core/error.h"
#include "scenes/core/replace_file.h"
#include "scenes/draft/scene_text.h"
#include "scenes/maps/map_file.h"
#include "scenes/mesh/obj_file.h"
#include "scenes/scene_file/scene_file.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/cli/option_values.h"
#include "validate/cli/parsed_option.h"
#include "validate/cli/progress.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

struct Arguments {
    std::filesystem::path mesh, height; // OBJ; a picture
    DraftWishes wishes;
    Stores stores = Stores::Height;
    std::pair<Wrap, Wrap> wraps{Wrap::Repeat, Wrap::Repeat};
    std::filesystem::path output; // the scene file
    bool force = false;           // also if it exists
};

Scheme parseScheme(const std::string& text) {
    const std::string scheme = parseChoice("--scheme", text, {"catmull-clark", "loop", "none"});
    return scheme == "loop" ? Scheme::Loop : scheme == "none" ? Scheme::None : Scheme::CatmullClark;
}

Stores parseStores(const std::string& text) {
    return parseChoice("--stores", text, {"height", "depth"}) == "height" ? Stores::Height : Stores::Depth;
}

Vec2 parseTiles(const std::string& text) {
    const auto [s, t] = parsePair("--tile", text, "4,2");
    return {parseTile("--tile", s), parseTile("--tile", t)};
}

double parseDepth(const std::string& text) {
    return parseLength("--depth", text);
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
    requireWritableFile(arguments.output, {arguments.mesh, arguments.height});
    const ControlMesh mesh = readObj(arguments.mesh);
    const HeightMap map =
        readHeightMap(arguments.height, arguments.stores, arguments.wraps.first, arguments.wraps.second);
    const std::string text =
        sceneText(draftScene(mesh, map, arguments.wishes), relativeTo(arguments.output, arguments.mesh),
                  relativeTo(arguments.output, arguments.height), map, arguments.stores == Stores::Height);
    const Scene scene = parseScene(arguments.output, text); // nothing is written that can't be read
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
    addParsed(command, "--depth", arguments->wishes.depth, parseDepth,
              "Relief depth in world units (default: automatic)")
        ->type_name("D");
    addParsed(command, "--tile", arguments->wishes.tile, parseTiles,
              "Repeats of the map along u and v (default: automatic)")
        ->type_name("S,T");
    addParsed(command, "--scheme", arguments->wishes.scheme, parseScheme,
              "Subdivision scheme of the mesh (default: automatic)")
        ->type_name("catmull-clark|loop|none");
    addParsed(command, "--stores", arguments->stores, parseStores,
              "Meaning of the image's values (default: height)")
        ->type_name("height|depth");
    addParsed(command, "--wrap", arguments->wraps, parseWraps,
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
