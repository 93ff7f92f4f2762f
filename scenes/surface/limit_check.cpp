#include "scenes/surface/limit_check.h"

#include "scenes/core/error.h"
#include "scenes/mesh/mesh_edges.h"
#include "scenes/surface/shared_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace plumbline {
namespace {

/// Relative to the mesh's size. Evaluated from two faces, a shared point either agrees to 1e-15 or differs
/// visibly.
constexpr double kGapFraction = 1e-9;
/// Segments between the points compared along an edge. Its ends are included, where one face may treat a
/// vertex as a corner and the other may not.
constexpr int kRate = 4;

bool isNonManifold(std::span<const HalfEdge> edge) {
    return edge.size() > 2 || (edge.size() == 2 && edge[0].forward == edge[1].forward);
}

class LimitTopology {
  public:
    explicit LimitTopology(const ControlMesh& mesh)
        : mesh_(mesh), edges_(mesh), edgeAfter_(mesh.faceVertices.size()), edgeCounts_(mesh.points.size()),
          touchesSharpEdge_(mesh.points.size()) {
        std::vector<bool> creased(edges_.edges().size());
        for (const SubdivisionTags::Crease& crease : mesh.tags.creases)
            if (crease.sharpness > 0) creased[edges_.indexOf(crease.from, crease.to)] = true;
        for (size_t i = 0; i < edges_.edges().size(); ++i) {
            const auto& edge = edges_.edges()[i];
            ++item(edgeCounts_, edge[0].low);
            ++item(edgeCounts_, edge[0].high);
            for (const HalfEdge& half : edge)
                item(edgeAfter_, half.forward ? half.lowCorner : half.highCorner) = i;
            if (!isNonManifold(edge) && !(creased[i] && edge.size() > 1)) continue;
            item(touchesSharpEdge_, edge[0].low) = true;
            item(touchesSharpEdge_, edge[0].high) = true;
        }
    }

    void check() const {
        for (const MeshFace& face : mesh_.faces()) {
            checkSizes(face);
            for (size_t k = 0; k < face.size; ++k) {
                const size_t before = edgeAfter_[face.corner(k + face.size - 1)],
                             after = edgeAfter_[face.corner(k)];
                if (const int other = doubletPartner(face.index, before, after);
                    other >= 0 && touchesSharp(face))
                    fail(face.index,
                         fmt::format("vertex {} has no edge beside those it shares with face {}, and a sharp "
                                     "edge is near",
                                     mesh_.faceVertices[face.corner(k)] + 1, faceNumber(mesh_, other)));
            }
        }
    }

  private:
    void checkSizes(const MeshFace& face) const {
        if (std::cmp_greater(face.size, kMaxLimitEdges))
            throw InputError(whereOfFace(mesh_, face.index), fmt::format("{} vertices", face.size),
                             fmt::format("at most {} in a face with a limit surface", kMaxLimitEdges),
                             "scheme \"none\" takes it");
        for (const int vertex : face.of(mesh_.faceVertices))
            if (const int edges = item(edgeCounts_, vertex); edges > kMaxLimitEdges)
                throw InputError(whereOfFace(mesh_, face.index),
                                 fmt::format("vertex {} has {} edges", vertex + 1, edges),
                                 fmt::format("at most {} at a vertex of a limit surface", kMaxLimitEdges),
                                 "scheme \"none\" takes it");
    }

    [[noreturn]] void fail(int face, const std::string& what) const {
        throw InputError(whereOfFace(mesh_, face), what, "a mesh OpenSubdiv can evaluate there",
                         "scheme \"none\" takes it");
    }

    bool touchesSharp(const MeshFace& face) const {
        return std::ranges::any_of(face.of(mesh_.faceVertices),
                                   [&](int vertex) { return item(touchesSharpEdge_, vertex); });
    }

    /// Another face incident to both edges; -1 if there is none.
    int doubletPartner(int face, size_t before, size_t after) const {
        std::span<const HalfEdge> few = edges_.edges()[before], many = edges_.edges()[after];
        if (few.size() > many.size()) std::swap(few, many);
        for (const HalfEdge& half : few) {
            if (half.face == face) continue;
            const auto place = std::partition_point(
                many.begin(), many.end(), [&](const HalfEdge& other) { return other.face < half.face; });
            if (place != many.end() && place->face == half.face) return half.face;
        }
        return -1;
    }

    const ControlMesh& mesh_;
    MeshEdges edges_;
    std::vector<size_t> edgeAfter_;      // per face corner: the edge to the next corner
    std::vector<int> edgeCounts_;        // of each vertex
    std::vector<bool> touchesSharpEdge_; // of each vertex
};

/// Faces at the vertices of non-manifold edges and at non-manifold vertices.
std::vector<int> facesAtNonManifoldVertices(const ControlMesh& mesh) {
    const MeshEdges edges(mesh);
    std::vector<bool> nonManifold(mesh.points.size());
    for (const auto& edge : edges.edges())
        if (isNonManifold(edge)) item(nonManifold, edge[0].low) = item(nonManifold, edge[0].high) = true;
    for (const int vertex : pinchedVertices(mesh, edges))
        item(nonManifold, vertex) = true;
    std::vector<int> faces;
    for (const MeshFace& face : mesh.faces())
        if (std::ranges::any_of(face.of(mesh.faceVertices),
                                [&](int vertex) { return item(nonManifold, vertex); }))
            faces.push_back(face.index);
    return faces;
}

} // namespace

void checkLimitTopology(const ControlMesh& mesh) {
    LimitTopology(mesh).check();
}

void checkFacesMeet(const BaseSurface& surface) {
    const ControlMesh& mesh = surface.mesh();
    const std::vector<int> suspects = facesAtNonManifoldVertices(mesh);
    if (suspects.empty()) return;
    Bounds bounds;
    for (const Vec3& point : mesh.points)
        bounds.add(point);
    struct Seen {
        int face;
        Vec3 position;
    };
    std::unordered_map<size_t, Seen> seen; // by the number of the shared sample
    const SharedSamples shared(surface, kRate);
    BaseSurface::Evaluator evaluator(surface);
    for (const int face : suspects) {
        if (!surface.hasLimit(face)) continue;
        const BaseSurface::FaceTessellation cut = surface.tessellateFace(face, kRate);
        for (int i = 0; i < cut.boundaryCount; ++i) {
            const auto& sample = item(cut.samples, i);
            evaluator.setPatch(sample.patch);
            const Vec3 position = evaluator.point(sample.u, sample.v).position;
            const auto [place, isNew] =
                seen.emplace(shared.onEdge(face, i / kRate, i % kRate), Seen{face, position});
            const double gap = glm::length(position - place->second.position);
            if (!(gap <= kGapFraction * bounds.diagonal()))
                throw InputError(
                    whereOfFace(mesh, face),
                    fmt::format("OpenSubdiv leaves a gap of {:.3g} between its surface and that of face {}",
                                gap, faceNumber(mesh, place->second.face)),
                    "fewer surfaces that meet there", "scheme \"none\" takes any number");
        }
    }
}

} // namespace plumbline
