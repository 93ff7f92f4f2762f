#include "scenes/mesh/mesh_edges.h"

#include "scenes/core/disjoint_sets.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace plumbline {

namespace {

template <class Action>
void forEachHalfEdge(const ControlMesh& mesh, const Action& action) {
    int first = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int size = item(mesh.faceSizes, face);
        for (int k = 0; k < size; ++k) {
            const int corner = first + k, next = first + (k + 1) % size;
            const int from = item(mesh.faceVertices, corner), to = item(mesh.faceVertices, next);
            if (from < to)
                action(HalfEdge{from, to, face, corner, next, true});
            else
                action(HalfEdge{to, from, face, next, corner, false});
        }
        first += size;
    }
}

} // namespace

MeshEdges::MeshEdges(const ControlMesh& mesh) : halfEdges_(mesh.faceVertices.size()) {
    // A counting sort by the lower vertex; only the few half edges of each vertex remain to be sorted.
    std::vector<size_t> firstOfVertex(mesh.points.size() + 1);
    forEachHalfEdge(mesh, [&](const HalfEdge& half) { ++item(firstOfVertex, half.low + 1); });
    std::partial_sum(firstOfVertex.begin(), firstOfVertex.end(), firstOfVertex.begin());
    std::vector<size_t> next = firstOfVertex;
    forEachHalfEdge(mesh, [&](const HalfEdge& half) { halfEdges_[item(next, half.low)++] = half; });
    for (size_t vertex = 0; vertex < mesh.points.size(); ++vertex)
        std::ranges::sort(
            std::span(halfEdges_)
                .subspan(firstOfVertex[vertex], firstOfVertex[vertex + 1] - firstOfVertex[vertex]),
            [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.face) < std::tie(b.high, b.face);
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

bool isClosed(const ControlMesh& mesh) {
    if (!mesh.tags.holes.empty()) return false;
    const MeshEdges edges(mesh);
    return std::ranges::all_of(edges.edges(), [](const std::span<const HalfEdge>& edge) {
        return 2 * std::ranges::count(edge, true, &HalfEdge::forward) == std::ssize(edge);
    });
}

std::vector<int> pinchedVertices(const ControlMesh& mesh, const MeshEdges& edges) {
    DisjointSets fans(mesh.faceVertices.size()); // of corners of faces
    for (const auto& edge : edges.edges())
        for (const HalfEdge& half : edge) {
            fans.join(half.lowCorner, edge[0].lowCorner);
            fans.join(half.highCorner, edge[0].highCorner);
        }
    std::vector<int> fanOfVertex(mesh.points.size(), -1);
    std::vector<bool> pinched(mesh.points.size());
    int corner = 0;
    for (const int vertex : mesh.faceVertices) {
        const int fan = fans.rootOf(corner++);
        int& fanSeen = item(fanOfVertex, vertex);
        if (fanSeen < 0) fanSeen = fan;
        if (fanSeen != fan) item(pinched, vertex) = true;
    }
    std::vector<int> result;
    for (int vertex = 0; vertex < countOf(pinched); ++vertex)
        if (item(pinched, vertex)) result.push_back(vertex);
    return result;
}

} // namespace plumbline
