// The edges of a control mesh with their incident faces. An edge may have any number of faces, so the mesh
// need not be a manifold.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <span>

namespace plumbline {

/// One face's use of an edge.
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

    /// The half edges of each edge, sorted by face; edges are sorted by their vertices.
    std::span<const std::span<const HalfEdge>> edges() const { return edges_; }
    bool contains(int vertex, int otherVertex) const;
    /// Index into edges() of an edge the mesh contains.
    size_t indexOf(int vertex, int otherVertex) const;

  private:
    size_t lowerBound(int low, int high) const;

    std::vector<HalfEdge> halfEdges_; // sorted by low, high, face
    std::vector<std::span<const HalfEdge>> edges_;
};

/// Whether the faces enclose a space: along each edge as many go one way as the other, and no face is a hole.
bool isClosed(const ControlMesh& mesh);

/// Non-manifold vertices whose faces form several fans that share no edge at the vertex. Ascending.
std::vector<int> pinchedVertices(const ControlMesh& mesh, const MeshEdges& edges);

} // namespace plumbline
