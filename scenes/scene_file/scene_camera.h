// The `[camera]` of a scene file.
#pragma once

#include "scenes/scene/camera.h"
#include "scenes/toml/toml_table.h"

namespace plumbline {

/// Keys: scenes/README.md. Throws InputError.
Camera readCamera(const TomlTable& table);

} // namespace plumbline
