// A polygon mesh as a user brings it: faces of any size, uvs and normals with indices of their own.
#pragma once

#include "scenes/core/index.h"
#include "scenes/core/math.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

/// How a surface follows from the control mesh.
enum class Scheme { CatmullClark, Loop, None };

/// What a control mesh says of its limit surface beyond its points: the tags of OpenSubdiv (and RenderMan).
/// Indices count from 0. Only Scheme::CatmullClark and Scheme::Loop look at them, but for holes.
struct SubdivisionTags {
    /// Sharpness is >= 0: 0 is smooth, n is sharp for n steps of subdivision and then smooth,
    /// kInfinitelySharp and more stays sharp (DeRose, Kass, Truong: Subdivision Surfaces in Character
    /// Animation, 1998).
    struct Crease {
        int from, to; // vertices of an edge, in any order
        double sharpness;
        int line = 0; // of the mesh's file, for messages; 0 if it doesn't stand there
    };
    struct Corner {
        int vertex;
        double sharpness;
        int line = 0;
    };
    struct Hole {
        int face;
        int line = 0;
    };
    std::vector<Crease> creases; // an edge more than once only with the same sharpness
    std::vector<Corner> corners; // likewise a vertex
    std::vector<Hole> holes;     // these faces shape their neighbors, but are no part of the surface
    /// True: the boundary is a curve that passes its corners by (VTX_BOUNDARY_EDGE_ONLY). Nothing to
    /// boundaryFacesSupportOnly.
    bool boundaryCornersRound = false;
};

/// OpenSubdiv's Sdc::Crease::SHARPNESS_INFINITE.
inline constexpr double kInfinitelySharp = 10;

/// A face by its corners, which are numbered through all faces of a mesh: where it is in faceVertices,
/// faceUvs and faceNormals.
struct MeshFace {
    int index;
    size_t firstCorner, size;

    /// Of an index, or whatever else a corner has, for all corners of the mesh: those of this face.
    template <class T>
    std::span<const T> of(const std::vector<T>& allCorners) const {
        return std::span(allCorners).subspan(firstCorner, size);
    }
    /// The corner `k` after the first, round the face.
    size_t corner(size_t k) const { return firstCorner + k % size; }
};

struct ControlMesh {
    std::string name;              // file or shape, for messages
    std::vector<Vec3> points;      // object space
    std::vector<int> faceSizes;    // vertices of each face, >= 3
    std::vector<int> faceVertices; // indices into points, counter-clockwise seen from outside
    std::vector<Vec2> uvs;         // origin lower left; empty if the mesh has none
    std::vector<int> faceUvs;      // indices into uvs, one per entry of faceVertices; empty if none
    std::vector<Vec3> normals;     // unit; empty if the mesh has none. Used by Scheme::None alone
    std::vector<int> faceNormals;  // indices into normals, one per entry of faceVertices; empty if none
    std::vector<int> faceLines;    // line of each face in its file, for messages; empty for a shape
    /// Why faceUvs (faceNormals) is empty though some faces of the file have such indices; else empty.
    std::string uvsMissing, normalsMissing;
    SubdivisionTags tags;
    std::vector<std::string> warnings; // "file:line: …": what the file says and the mesh can't hold
    /// True: faces on the boundary only support the limit surface and are not part of it, so that a bicubic
    /// patch reaches exactly to the edge of the rest (OpenSubdiv's VTX_BOUNDARY_NONE). False: the boundary is
    /// a curve that keeps its corners (VTX_BOUNDARY_EDGE_AND_CORNER).
    bool boundaryFacesSupportOnly = false;

    /// The faces in order. Their sizes must not be negative.
    std::vector<MeshFace> faces() const;
    int faceCount() const { return countOf(faceSizes); }
    bool hasUvs() const { return !faceUvs.empty(); }
    bool hasNormals() const { return !faceNormals.empty(); }
    // What stands at a corner; the mesh must have passed checkControlMesh.
    const Vec3& pointAt(size_t corner) const { return item(points, faceVertices[corner]); }
    const Vec2& uvAt(size_t corner) const { return item(uvs, faceUvs[corner]); }
    const Vec3& normalAt(size_t corner) const { return item(normals, faceNormals[corner]); }
};

/// "name:line: face 3", or without the line for a mesh that has none.
std::string whereOfFace(const ControlMesh& mesh, int face);

/// Throws InputError naming mesh, face and reason: an index out of range, a face with fewer than 3 vertices
/// or with one of them twice, two faces with the same vertices in the same order, a coordinate that isn't
/// finite, no face at all, no area, Loop with a face that is not a triangle, None with a normal of length 0,
/// tags of an edge, a vertex or a face that isn't there, with two kinds of sharpness, or with one that is
/// negative or not finite. What else may be odd with a mesh is handled; mesh_defects.h tells of it.
void checkControlMesh(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
