// The `[camera]` of a scene file.
#pragma once

#include "camera.h"
#include "toml_file.h"

namespace plumbline {

/// Keys: scenes/README.md. Throws InputError.
Camera readCamera(const TomlTable& table);

} // namespace plumbline
