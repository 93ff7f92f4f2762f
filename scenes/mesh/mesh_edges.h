// The edges of a control mesh with the faces on them, however many: a mesh need not be a manifold here.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <span>

namespace plumbline {

/// A face's walk along one of its edges.
struct HalfEdge {
    int low, high; // vertices, low < high
    int face;
    int lowCorner, highCorner; // of the face, as indices into ControlMesh::faceVertices
    bool forward;              // the face goes from low to high
};

class MeshEdges {
  public:
    /// The mesh's indices must be in range and a face's vertices distinct.
    explicit MeshEdges(const ControlMesh& mesh);

    /// The half edges of each edge, by face; edges in order of their vertices.
    std::span<const std::span<const HalfEdge>> edges() const { return edges_; }
    bool contains(int vertex, int otherVertex) const;
    /// Index into edges() of an edge the mesh contains.
    size_t indexOf(int vertex, int otherVertex) const;

  private:
    size_t lowerBound(int low, int high) const;

    std::vector<HalfEdge> halfEdges_; // sorted by low, high, face
    std::vector<std::span<const HalfEdge>> edges_;
};

/// Vertices where faces meet that share no edge there, nor are joined through others that do. Ascending.
std::vector<int> pinchedVertices(const ControlMesh& mesh, const MeshEdges& edges);

} // namespace plumbline
