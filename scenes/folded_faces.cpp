#include "folded_faces.h"

#include "error.h"
#include "mesh_edges.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

class FoldFinder {
  public:
    explicit FoldFinder(const ControlMesh& mesh)
        : mesh_(mesh), edges_(mesh), firstCorners_(mesh.firstCorners()), edgeAfter_(mesh.faceVertices.size()),
          touchesSharpEdge_(mesh.points.size()) {
        std::vector<bool> creased(edges_.edges().size());
        for (const SubdivisionTags::Crease& crease : mesh.tags.creases)
            if (crease.sharpness > 0) creased[edges_.indexOf(crease.from, crease.to)] = true;
        for (size_t i = 0; i < edges_.edges().size(); ++i) {
            const auto& edge = edges_.edges()[i];
            for (const HalfEdge& half : edge)
                edgeAfter_[static_cast<size_t>(half.forward ? half.lowCorner : half.highCorner)] = i;
            if (!isNonManifold(i) && !(creased[i] && edge.size() > 1)) continue;
            touchesSharpEdge_[static_cast<size_t>(edge[0].low)] = true;
            touchesSharpEdge_[static_cast<size_t>(edge[0].high)] = true;
        }
    }

    void check() const {
        for (int face = 0; face < mesh_.faceCount(); ++face) {
            const auto size = static_cast<size_t>(mesh_.faceSizes[static_cast<size_t>(face)]);
            const size_t first = firstCorners_[static_cast<size_t>(face)];
            for (size_t k = 0; k < size; ++k) {
                const size_t before = edgeAfter_[first + (k + size - 1) % size],
                             after = edgeAfter_[first + k];
                const int vertex = mesh_.faceVertices[first + k];
                if (const int other = doubletPartner(face, before, after);
                    other >= 0 && touchesSharp(first, size))
                    fail(face,
                         fmt::format("vertex {} has no edge beside those it shares with face {}, and a sharp "
                                     "edge is near",
                                     vertex + 1, other + 1));
                if (size == 3 && isNonManifold(edgeAfter_[first + (k + 1) % 3]) &&
                    isTipOfThree(face, before, after))
                    fail(face, fmt::format(
                                   "vertex {} has three faces alone, and more than one surface meets in the "
                                   "edge opposite",
                                   vertex + 1));
            }
        }
    }

  private:
    [[noreturn]] void fail(int face, const std::string& what) const {
        throw InputError(whereOfFace(mesh_, face), what, "a mesh OpenSubdiv can evaluate there",
                         "scheme \"none\" takes it");
    }

    bool isNonManifold(size_t index) const {
        const auto& edge = edges_.edges()[index];
        return edge.size() > 2 || (edge.size() == 2 && edge[0].forward == edge[1].forward);
    }

    bool touchesSharp(size_t firstCorner, size_t size) const {
        for (size_t corner = firstCorner; corner < firstCorner + size; ++corner)
            if (touchesSharpEdge_[static_cast<size_t>(mesh_.faceVertices[corner])]) return true;
        return false;
    }

    /// Another face on both edges; -1 if there is none.
    int doubletPartner(int face, size_t before, size_t after) const {
        for (const HalfEdge& half : edges_.edges()[before])
            for (const HalfEdge& otherHalf : edges_.edges()[after])
                if (half.face == otherHalf.face && half.face != face) return half.face;
        return -1;
    }

    /// The triangles across both edges have the same third vertex: with this one they surround the vertex.
    bool isTipOfThree(int face, size_t before, size_t after) const {
        const int tip = tipAcross(face, before);
        return tip >= 0 && tip == tipAcross(face, after);
    }

    /// Third vertex of the triangle across a manifold edge of a face; -1 if there is no such triangle.
    int tipAcross(int face, size_t index) const {
        const auto& edge = edges_.edges()[index];
        if (edge.size() != 2 || isNonManifold(index)) return -1;
        const HalfEdge& across = edge[0].face == face ? edge[1] : edge[0];
        if (mesh_.faceSizes[static_cast<size_t>(across.face)] != 3) return -1;
        const size_t first = firstCorners_[static_cast<size_t>(across.face)];
        for (size_t corner = first; corner < first + 3; ++corner)
            if (mesh_.faceVertices[corner] != across.low && mesh_.faceVertices[corner] != across.high)
                return mesh_.faceVertices[corner];
        return -1;
    }

    const ControlMesh& mesh_;
    MeshEdges edges_;
    std::vector<size_t> firstCorners_;   // of each face
    std::vector<size_t> edgeAfter_;      // of each corner of a face: the edge from there to the next
    std::vector<bool> touchesSharpEdge_; // of each vertex
};

} // namespace

void checkFoldedFaces(const ControlMesh& mesh) {
    FoldFinder(mesh).check();
}

} // namespace plumbline
