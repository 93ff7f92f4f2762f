// A polygon mesh as read from a file: faces of any size, with separate uv and normal indices.
#pragma once

#include "scenes/core/index.h"
#include "scenes/core/math.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

/// How the surface is defined by the control mesh.
enum class Scheme { CatmullClark, Loop, None };

/// Subdivision tags of OpenSubdiv (and RenderMan) that shape the limit surface. Indices count from 0.
/// Scheme::None uses only the holes.
struct SubdivisionTags {
    /// Sharpness is >= 0: 0 is smooth, n is sharp for n subdivision steps and then smooth, and
    /// kInfinitelySharp or more is always sharp (DeRose, Kass, Truong: Subdivision Surfaces in Character
    /// Animation, 1998).
    struct Crease {
        int from, to; // vertices of an edge, in any order
        double sharpness;
        int line = 0; // of the mesh's file, for messages; 0 if it isn't from that file
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
    std::vector<Crease> creases; // an edge may be repeated only with equal sharpness
    std::vector<Corner> corners; // likewise a vertex
    std::vector<Hole> holes;     // faces that shape their neighbors but aren't part of the surface
    /// True: the boundary curve rounds off its corners (VTX_BOUNDARY_EDGE_ONLY). Ignored if
    /// boundaryFacesSupportOnly is set.
    bool boundaryCornersRound = false;
};

/// OpenSubdiv's Sdc::Crease::SHARPNESS_INFINITE.
inline constexpr double kInfinitelySharp = 10;

/// A face as a range of corners. Corners are numbered consecutively over all faces of a mesh and index
/// faceVertices, faceUvs and faceNormals.
struct MeshFace {
    int index;
    size_t firstCorner, size;

    /// The part of a per-corner array that belongs to this face.
    template <class T>
    std::span<const T> of(const std::vector<T>& allCorners) const {
        return std::span(allCorners).subspan(firstCorner, size);
    }
    /// The corner `k` after the first, cyclically.
    size_t corner(size_t k) const { return firstCorner + k % size; }
};

struct ControlMesh {
    std::string name;              // file or shape, for messages
    std::vector<Vec3> points;      // object space
    std::vector<int> faceSizes;    // vertices of each face, >= 3
    std::vector<int> faceVertices; // indices into points, counterclockwise seen from outside
    std::vector<Vec2> uvs;         // origin lower left; empty if the mesh has none
    std::vector<int> faceUvs;      // indices into uvs, one per entry of faceVertices; empty if none
    std::vector<Vec3> normals;     // unit; empty if the mesh has none. Used only by Scheme::None
    std::vector<int> faceNormals;  // indices into normals, one per entry of faceVertices; empty if none
    std::vector<int> faceLines;    // line of each face in its file, for messages; empty for a shape
    std::vector<int> faceNumbers; // of each face in its file, from 1, for messages; empty if they are 1, 2, …
    /// Why faceUvs (faceNormals) is empty although some faces of the file have such indices; otherwise empty.
    std::string uvsMissing, normalsMissing;
    SubdivisionTags tags;
    std::vector<std::string> warnings; // "file:line: …": contents of the file that the mesh can't represent
    /// True: faces on the boundary only support the limit surface and are not part of it, so that bicubic
    /// patches extend exactly to the edge of the remaining faces (OpenSubdiv's VTX_BOUNDARY_NONE). False: the
    /// boundary is a curve with sharp corners (VTX_BOUNDARY_EDGE_AND_CORNER).
    bool boundaryFacesSupportOnly = false;

    /// The faces in order. Their sizes must not be negative.
    std::vector<MeshFace> faces() const;
    int faceCount() const { return countOf(faceSizes); }
    bool hasUvs() const { return !faceUvs.empty(); }
    bool hasNormals() const { return !faceNormals.empty(); }
    // Attributes of a corner; the mesh must have passed checkControlMesh.
    const Vec3& pointAt(size_t corner) const { return item(points, faceVertices[corner]); }
    const Vec2& uvAt(size_t corner) const { return item(uvs, faceUvs[corner]); }
    const Vec3& normalAt(size_t corner) const { return item(normals, faceNormals[corner]); }
};

/// The number of a face in messages: in its file, from 1.
int faceNumber(const ControlMesh& mesh, int face);

/// "name:line: face 3", or without the line for a mesh that has none.
std::string whereOfFace(const ControlMesh& mesh, int face);

/// Throws InputError naming the mesh, the face and the reason: an index out of range, a face with fewer than
/// 3 vertices or with a repeated vertex, two faces with the same vertices in the same order, a coordinate
/// that isn't finite, no face, no area, a face that isn't a triangle under Loop, a zero normal under None, or
/// a tag of an edge, vertex or face that doesn't exist, with two values of sharpness, or with one that is
/// negative or not finite. Other defects are tolerated; mesh_defects.h reports them.
void checkControlMesh(const ControlMesh& mesh, Scheme scheme);

} // namespace plumbline
