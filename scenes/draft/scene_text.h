// The scene file of a draft: values with their reasons as comments.
#pragma once

#include "scenes/draft/scene_draft.h"

#include <filesystem>
#include <string>

namespace plumbline {

/// `meshFile` and `mapFile` are written as given; they must be relative to the scene file's folder.
/// `storesHeight`: whether the map's values are heights rather than depths. Throws InputError for a path that
/// isn't UTF-8, which TOML requires.
std::string sceneText(const SceneDraft& draft, const std::filesystem::path& meshFile,
                      const std::filesystem::path& mapFile, const HeightMap& map, bool storesHeight);

} // namespace plumbline
