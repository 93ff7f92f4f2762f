// Wavefront OBJ in one pass over its text: polygons kept, uv and normal indices of their own; subdivision
// tags through obj_tags.h. No library for it knows the lines that errors name.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <filesystem>

namespace plumbline {

/// Throws InputError with file and line: missing, truncated, index out of range, not a number.
ControlMesh readObj(const std::filesystem::path& file);

} // namespace plumbline
