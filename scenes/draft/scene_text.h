// The scene file of a draft: values with their reasons as comments.
#pragma once

#include "scenes/draft/scene_draft.h"

#include <filesystem>
#include <string>

namespace plumbline {

/// The scene file of a draft. `meshFile`, `mapFile`: as the file is to name them, relative to its folder.
/// `storesHeight`: what the map's values are. Throws InputError for a path that isn't UTF-8, as a TOML file
/// must be.
std::string sceneText(const SceneDraft& draft, const std::filesystem::path& meshFile,
                      const std::filesystem::path& mapFile, const HeightMap& map, bool storesHeight);

} // namespace plumbline
