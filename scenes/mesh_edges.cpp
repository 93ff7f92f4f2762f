#include "mesh_edges.h"

#include <algorithm>
#include <tuple>

namespace plumbline {

MeshEdges::MeshEdges(const ControlMesh& mesh) {
    int first = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int size = mesh.faceSizes[static_cast<size_t>(face)];
        for (int k = 0; k < size; ++k) {
            const int corner = first + k, next = first + (k + 1) % size;
            const int from = mesh.faceVertices[static_cast<size_t>(corner)],
                      to = mesh.faceVertices[static_cast<size_t>(next)];
            if (from < to)
                halfEdges_.push_back({from, to, face, corner, next, true});
            else
                halfEdges_.push_back({to, from, face, next, corner, false});
        }
        first += size;
    }
    std::sort(halfEdges_.begin(), halfEdges_.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    for (size_t begin = 0, end = 0; begin < halfEdges_.size(); begin = end) {
        const HalfEdge& half = halfEdges_[begin];
        while (end < halfEdges_.size() && halfEdges_[end].low == half.low &&
               halfEdges_[end].high == half.high)
            ++end;
        edges_.emplace_back(&half, end - begin);
    }
}

size_t MeshEdges::lowerBound(int low, int high) const {
    const auto isBefore = [&](const std::span<const HalfEdge>& edge) {
        return std::tie(edge[0].low, edge[0].high) < std::tie(low, high);
    };
    return static_cast<size_t>(std::partition_point(edges_.begin(), edges_.end(), isBefore) - edges_.begin());
}

bool MeshEdges::contains(int vertex, int otherVertex) const {
    const auto [low, high] = std::minmax(vertex, otherVertex);
    const size_t index = lowerBound(low, high);
    return index < edges_.size() && edges_[index][0].low == low && edges_[index][0].high == high;
}

size_t MeshEdges::indexOf(int vertex, int otherVertex) const {
    const auto [low, high] = std::minmax(vertex, otherVertex);
    return lowerBound(low, high);
}

} // namespace plumbline
