// TOML to Scene. Every key is documented in scenes/README.md; unknown keys are errors.
#pragma once

#include "scenes/scene/scene.h"

#include <filesystem>

namespace plumbline {

/// Fields to be read as if the file had other values there, in order: "object.torus.relief.depth=0.1"
/// (TomlTable::change). Files named in one are relative to the scene file, as ever.
using SceneChanges = std::vector<std::string>;

/// Reads a scene, its meshes and its maps. Throws InputError: "file:line: field: what; expected …", or
/// "--scene-set path=value: what; …" about a change.
Scene readScene(const std::filesystem::path& file, const SceneChanges& changes = {});

/// The same of a file that would hold `text`; it needn't exist yet.
Scene parseScene(const std::filesystem::path& file, const std::string& text);

/// One height map of a scene, by the name it has there. Throws InputError: what readScene refuses, or a name
/// that lists those there are.
std::shared_ptr<const HeightMap> readSceneMap(const std::filesystem::path& file, const std::string& name);

} // namespace plumbline
