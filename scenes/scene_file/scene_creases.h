// The `creases = [{ … }, …]` of an object in a scene file.
#pragma once

#include "scenes/mesh/control_mesh.h"
#include "scenes/toml/toml_table.h"

namespace plumbline {

/// Adds to the tags from the mesh's file; for an edge or vertex tagged in both, the scene file takes
/// precedence. Vertices count from 1. Keys: scenes/README.md. Throws InputError with the line of the scene
/// file, also under scheme None, where creases have no meaning.
void readCreases(const TomlTable& object, Scheme scheme, ControlMesh& mesh);

} // namespace plumbline
