// A polygon mesh as a user brings it: faces of any size, uvs and normals with indices of their own.
#pragma once

#include "math.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline {

/// How a surface follows from the control mesh.
enum class Scheme { CatmullClark, Loop, None };

struct ControlMesh {
    std::string name;                     // file or shape, for messages
    std::vector<Vec3> points;             // object space
    std::vector<int> faceSizes;           // vertices of each face, >= 3
    std::vector<int> faceVertices;        // indices into points, counter-clockwise seen from outside
    std::vector<Vec2> uvs;                // origin lower left; empty if the mesh has none
    std::vector<int> faceUvs;             // indices into uvs, one per entry of faceVertices; empty if none
    std::vector<Vec3> normals;            // unit; empty if the mesh has none. Used by Scheme::None alone
    std::vector<int> faceNormals;         // indices into normals, one per entry of faceVertices; empty if none
    std::vector<int> faceLines;           // line of each face in its file, for messages; empty for a shape
    /// Why faceUvs (faceNormals) is empty though some faces of the file have such indices; else empty.
    std::string uvsMissing, normalsMissing;
    /// True: faces on the boundary only support the limit surface and are not part of it, so that a bicubic patch
    /// reaches exactly to the edge of the rest (OpenSubdiv's VTX_BOUNDARY_NONE). False: the boundary is a curve that
    /// keeps its corners (VTX_BOUNDARY_EDGE_AND_CORNER).
    bool boundaryFacesSupportOnly = false;

    int faceCount() const { return static_cast<int>(faceSizes.size()); }
    bool hasUvs() const { return !faceUvs.empty(); }
    bool hasNormals() const { return !faceNormals.empty(); }
};

/// Throws InputError naming mesh, face and reason: an index out of range, a face with fewer than 3 vertices, a
/// coordinate that isn't finite, no face at all, no area, Loop with a face that is not a triangle.
void checkControlMesh(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
