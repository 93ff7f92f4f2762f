// Writes the displaced surface as a triangle mesh, so that other programs can render exactly the surface that
// the reference traces.
//
// World space (right-handed, Y up), world units, with exactly the floats that the reference traces. Each
// vertex has the unit normal of the displaced surface and st, tiled and unwrapped; each triangle has its
// object. Vertices are shared as described in mesh_numbers.h; at a crease there is one for each of its
// normals. The file's extension selects the format:
//   .ply  binary, little-endian. Vertex: float x y z nx ny nz s t. Face: uchar + int vertex_indices, int
//         object_id, which is the frame's channel id. Comments name the scene and the objects.
//   .obj  text. v, vt and vn share indices; each object has an `o` line, in the order of ids.
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

/// `objects`: element k has the id k + 1. `comments`: one line each. The file is replaced atomically. In
/// addition to the meshes, writing takes about 5 bytes of memory per micro-vertex. Throws InputError for
/// another extension, a file that can't be written, or more than 2^31 - 1 vertices.
MeshFileSize writeMeshFile(const std::filesystem::path& file, std::span<const MeshFileObject> objects,
                           std::span<const std::string> comments);

} // namespace plumbline
