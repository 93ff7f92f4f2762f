// The scenes that ship with the program: scenes/library/NAME.toml.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline {

/// The file of a scene given as a path or by its name in scenes/library/. Throws InputError that lists the
/// names.
std::filesystem::path findScene(const std::string& nameOrPath);

/// Names and purposes of the scenes in scenes/library/, sorted.
struct LibraryScene {
    std::string name;
    std::string purpose;
    std::filesystem::path file;
};
std::vector<LibraryScene> libraryScenes();

} // namespace plumbline
