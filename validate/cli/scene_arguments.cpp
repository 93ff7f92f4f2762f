#include "validate/cli/scene_arguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace plumbline {
namespace {

constexpr const char* kHelp = "A scene file or a name of the library";

CLI::Option* add(CLI::App& command, SceneArguments& arguments, const std::string& help) {
    CLI::Option* scene = command.add_option("SCENE", arguments.scene, help);
    command
        .add_option("--scene-set", arguments.changes,
                    "Set a field of the scene, for example camera.width=400; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    return scene;
}

} // namespace

void SceneArguments::addTo(CLI::App& command) {
    add(command, *this, kHelp)->required();
}

void SceneArguments::addOptionalTo(CLI::App& command) {
    add(command, *this, fmt::format("{} (default: {})", kHelp, scene));
}

} // namespace plumbline
