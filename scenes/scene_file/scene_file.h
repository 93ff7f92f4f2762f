// Reads scene files. Every key is documented in scenes/README.md; unknown keys are errors.
#pragma once

#include "scenes/scene/scene.h"

#include <filesystem>

namespace plumbline {

/// Overrides of fields, applied in order, for example "object.torus.relief.depth=0.1" (TomlTable::change).
/// File names are relative to the scene file's folder, as in the file itself.
using SceneChanges = std::vector<std::string>;

/// Reads a scene, its meshes and its maps. Throws InputError: "file:line: field: what; expected …", or
/// "--scene-set path=value: what; …" about a change.
Scene readScene(const std::filesystem::path& file, const SceneChanges& changes = {});

/// The same for a file with the contents `text`; the file need not exist.
Scene parseScene(const std::filesystem::path& file, const std::string& text);

/// The height map called `name` in a scene. Throws InputError if readScene does, or if there is no such map;
/// the message lists the names.
std::shared_ptr<const HeightMap> readSceneMap(const std::filesystem::path& file, const std::string& name);

} // namespace plumbline
