#include "scenes/surface/limit_check.h"

#include "scenes/core/error.h"
#include "scenes/mesh/mesh_edges.h"
#include "scenes/surface/shared_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace plumbline {
namespace {

/// Evaluated from two faces, a place is the same to 1e-15 of the mesh's size, or off by a visible amount.
constexpr double kGapFraction = 1e-9;
/// Places compared along an edge: its ends, where faces take the same vertex for a corner and for none, and
/// some between.
constexpr int kRate = 4;

bool isNonManifold(std::span<const HalfEdge> edge) {
    return edge.size() > 2 || (edge.size() == 2 && edge[0].forward == edge[1].forward);
}

class LimitTopology {
  public:
    explicit LimitTopology(const ControlMesh& mesh)
        : mesh_(mesh), edges_(mesh), firstCorners_(mesh.firstCorners()), edgeAfter_(mesh.faceVertices.size()),
          edgeCounts_(mesh.points.size()), touchesSharpEdge_(mesh.points.size()) {
        std::vector<bool> creased(edges_.edges().size());
        for (const SubdivisionTags::Crease& crease : mesh.tags.creases)
            if (crease.sharpness > 0) creased[edges_.indexOf(crease.from, crease.to)] = true;
        for (size_t i = 0; i < edges_.edges().size(); ++i) {
            const auto& edge = edges_.edges()[i];
            ++edgeCounts_[static_cast<size_t>(edge[0].low)];
            ++edgeCounts_[static_cast<size_t>(edge[0].high)];
            for (const HalfEdge& half : edge)
                edgeAfter_[static_cast<size_t>(half.forward ? half.lowCorner : half.highCorner)] = i;
            if (!isNonManifold(edge) && !(creased[i] && edge.size() > 1)) continue;
            touchesSharpEdge_[static_cast<size_t>(edge[0].low)] = true;
            touchesSharpEdge_[static_cast<size_t>(edge[0].high)] = true;
        }
    }

    void check() const {
        for (int face = 0; face < mesh_.faceCount(); ++face) {
            const auto size = static_cast<size_t>(mesh_.faceSizes[static_cast<size_t>(face)]);
            const size_t first = firstCorners_[static_cast<size_t>(face)];
            checkSizes(face, first, size);
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
            }
        }
    }

  private:
    void checkSizes(int face, size_t firstCorner, size_t size) const {
        const auto most = static_cast<size_t>(kMostLimitEdges);
        if (size > most)
            throw InputError(whereOfFace(mesh_, face), fmt::format("{} vertices", size),
                             fmt::format("at most {} in a face with a limit surface", most),
                             "scheme \"none\" takes it");
        for (size_t corner = firstCorner; corner < firstCorner + size; ++corner) {
            const int vertex = mesh_.faceVertices[corner];
            if (const int edges = edgeCounts_[static_cast<size_t>(vertex)]; edges > kMostLimitEdges)
                throw InputError(whereOfFace(mesh_, face),
                                 fmt::format("vertex {} has {} edges", vertex + 1, edges),
                                 fmt::format("at most {} at a vertex of a limit surface", kMostLimitEdges),
                                 "scheme \"none\" takes it");
        }
    }

    [[noreturn]] void fail(int face, const std::string& what) const {
        throw InputError(whereOfFace(mesh_, face), what, "a mesh OpenSubdiv can evaluate there",
                         "scheme \"none\" takes it");
    }

    bool touchesSharp(size_t firstCorner, size_t size) const {
        for (size_t corner = firstCorner; corner < firstCorner + size; ++corner)
            if (touchesSharpEdge_[static_cast<size_t>(mesh_.faceVertices[corner])]) return true;
        return false;
    }

    /// Another face on both edges; -1 if there is none. Looked up in the longer list, as an edge may have any
    /// number of faces.
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
    std::vector<size_t> firstCorners_;   // of each face
    std::vector<size_t> edgeAfter_;      // of each corner of a face: the edge from there to the next
    std::vector<int> edgeCounts_;        // of each vertex
    std::vector<bool> touchesSharpEdge_; // of each vertex
};

/// Faces at vertices of edges that more than one surface meets in, and at vertices that faces share without
/// an edge.
std::vector<int> facesAtNonManifoldVertices(const ControlMesh& mesh) {
    const MeshEdges edges(mesh);
    std::vector<bool> nonManifold(mesh.points.size());
    for (const auto& edge : edges.edges())
        if (isNonManifold(edge)) {
            nonManifold[static_cast<size_t>(edge[0].low)] = true;
            nonManifold[static_cast<size_t>(edge[0].high)] = true;
        }
    for (const int vertex : pinchedVertices(mesh, edges))
        nonManifold[static_cast<size_t>(vertex)] = true;
    std::vector<int> faces;
    size_t corner = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        bool touches = false;
        for (const size_t end = corner + static_cast<size_t>(mesh.faceSizes[static_cast<size_t>(face)]);
             corner < end; ++corner)
            touches |= nonManifold[static_cast<size_t>(mesh.faceVertices[corner])];
        if (touches) faces.push_back(face);
    }
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
            const auto& sample = cut.samples[static_cast<size_t>(i)];
            evaluator.setPatch(sample.patch);
            const Vec3 position = evaluator.point(sample.u, sample.v).position;
            const auto [place, isNew] =
                seen.emplace(shared.onEdge(face, i / kRate, i % kRate), Seen{face, position});
            const double gap = glm::length(position - place->second.position);
            if (!(gap <= kGapFraction * bounds.diagonal()))
                throw InputError(
                    whereOfFace(mesh, face),
                    fmt::format("OpenSubdiv leaves a gap of {:.3g} between its surface and that of face {}",
                                gap, place->second.face + 1),
                    "fewer surfaces that meet there", "scheme \"none\" takes any number");
        }
    }
}

} // namespace plumbline
