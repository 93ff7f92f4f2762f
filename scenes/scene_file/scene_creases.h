// The `creases = [{ … }, …]` of an object in a scene file.
#pragma once

#include "scenes/mesh/control_mesh.h"
#include "scenes/toml/toml_table.h"

namespace plumbline {

/// Adds to the tags the mesh has from its file; where both speak of an edge or a vertex, the scene file
/// counts. Vertices count from 1. Keys: scenes/README.md. Throws InputError with the line of the scene file,
/// for scheme None too, where creases have no meaning.
void readCreases(const TomlTable& object, Scheme scheme, ControlMesh& mesh);

} // namespace plumbline
