// The `[camera]` of a scene file.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/toml/toml_table.h"

#include <optional>
#include <string>

namespace plumbline {

/// Keys: scenes/README.md. Throws InputError.
Camera readCamera(const TomlTable& table);

/// What is wrong with a camera's numbers, by a scene file's field.
struct CameraFault {
    const char* field;
    std::string found, expected;
};
/// The first that no scene file could have, of a camera that comes from elsewhere; nullopt if there is none.
std::optional<CameraFault> findFault(const Camera& camera);

} // namespace plumbline
