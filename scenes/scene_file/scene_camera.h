// The `[camera]` of a scene file.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/toml/toml_table.h"

#include <optional>
#include <string>

namespace plumbline {

/// Keys: scenes/README.md. Throws InputError.
Camera readCamera(const TomlTable& table);

/// An invalid value of a camera, named by its field in a scene file.
struct CameraFault {
    const char* field;
    std::string found, expected;
};
/// The first value that a scene file would not accept, for a camera from another source; nullopt if all are
/// valid.
std::optional<CameraFault> findFault(const Camera& camera);

} // namespace plumbline
