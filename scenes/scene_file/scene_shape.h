// Creates the control mesh of the `shape = { kind = … }` of a scene file.
#pragma once

#include "scenes/mesh/control_mesh.h"
#include "scenes/toml/toml_table.h"

namespace plumbline {

/// Kinds, parameters and defaults: scenes/README.md. Throws InputError with the file's line.
ControlMesh readShape(const TomlTable& shape);

} // namespace plumbline
