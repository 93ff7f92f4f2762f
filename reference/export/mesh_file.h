// The displaced surface as a file of triangles, so that other programs render the very surface the reference
// traces.
//
// World space (right-handed, Y up), world units; the floats the reference traces. Per vertex the unit normal
// of the displaced surface and st, tiled and unwrapped; per triangle the object. Vertices are shared as
// mesh_numbers.h says; at a crease a vertex has the first face's normal. By the file's name:
//   .ply  binary, little-endian. Vertex: float x y z nx ny nz s t. Face: uchar + int vertex_indices, int
//   object_id, which
//         is the frame's channel id. Comments name the scene and the objects.
//   .obj  text; v, vt and vn have one number; an `o` for each object, in the order of their ids.
#pragma once

#include "scenes/surface/micro_mesh.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

struct MeshFileObject {
    std::string name;
    const MicroMesh* mesh; // with attributes
};

struct MeshFileSize {
    uint64_t vertices = 0, triangles = 0, bytes = 0;
};

/// Throws InputError unless the name ends in .ply or .obj.
void requireMeshFileName(const std::filesystem::path& file);

/// `objects`: number k has id k + 1. `comments`: a line each. Write-then-rename, a piece at a time; beside
/// the meshes it takes about 5 bytes a micro-vertex. Throws InputError for another kind of file, a place that
/// can't be written, or more than 2^31 - 1 vertices.
MeshFileSize writeMeshFile(const std::filesystem::path& file, std::span<const MeshFileObject> objects,
                           std::span<const std::string> comments);

} // namespace plumbline
