// SCENE and --scene-set.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace plumbline {

struct SceneArguments {
    std::string scene = "small_torus"; // path or library name
    std::vector<std::string> changes;  // PATH=VALUE, scenes/scene_file/scene_file.h

    void addTo(CLI::App& command);
    /// SCENE may be left out.
    void addOptionalTo(CLI::App& command);
};

} // namespace plumbline
