// The field `merge` of an object, and the warning that recommends it.
#pragma once

#include "scenes/mesh/control_mesh.h"
#include "scenes/toml/toml_table.h"

#include <optional>

namespace plumbline {

/// `merge = true` merges vertices at the same place (merge_vertices.h), `merge = DISTANCE` those within a
/// distance in the mesh's units. Creases must have been read before, because they count the file's vertices.
void readMerge(const TomlTable& object, ControlMesh& mesh);

/// A warning if faces of the mesh touch along edges that they don't share; nothing if there are none.
std::optional<std::string> looseFacesWarning(const ControlMesh& mesh);

} // namespace plumbline
