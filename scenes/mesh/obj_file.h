// Reads Wavefront OBJ files in one pass, keeping polygons and separate uv and normal indices; obj_tags.h
// reads the subdivision tags. OBJ libraries aren't used because they don't report the line numbers needed for
// error messages.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <filesystem>

namespace plumbline {

/// Throws InputError with file and line for a file that is missing or malformed.
ControlMesh readObj(const std::filesystem::path& file);

} // namespace plumbline
