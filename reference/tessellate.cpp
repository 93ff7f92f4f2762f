#include "tessellate.h"

#include "../scenes/displaced_surface.h"
#include "../scenes/shared_samples.h"
#include "grid_layout.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cassert>

namespace plumbline {

namespace {

/// Patch and (u,v) of the point `step` of `rate` segments along edge k of a face.
BaseSurface::FaceTessellation::Sample edgePoint(const BaseSurface& surface, int facePatch, int faceSize,
                                                int k, int step, int rate) {
    const BaseSurface::Patch& patch = surface.patches()[static_cast<size_t>(facePatch)];
    const double t = static_cast<double>(step) / rate;
    if (patch.subFace)
        return t <= 0.5
                   ? BaseSurface::FaceTessellation::Sample{facePatch + k, 2 * t, 0}
                   : BaseSurface::FaceTessellation::Sample{facePatch + (k + 1) % faceSize, 0, 2 * (1 - t)};
    if (patch.triangular) {
        if (k == 0) return {facePatch, t, 0};
        return k == 1 ? BaseSurface::FaceTessellation::Sample{facePatch, 1 - t, t}
                      : BaseSurface::FaceTessellation::Sample{facePatch, 0, 1 - t};
    }
    switch (k) {
    case 0:
        return {facePatch, t, 0};
    case 1:
        return {facePatch, 1, t};
    case 2:
        return {facePatch, 1 - t, 1};
    default:
        return {facePatch, 0, 1 - t};
    }
}

/// What a vertex of the micro-mesh holds.
struct Vertex {
    Vec3f position{0}, normal{0};
    Vec2f st{0};
};

class Tessellator {
  public:
    Tessellator(const BaseSurface& surface, const Relief* relief, int rate, bool attributes)
        : surface_(surface), relief_(relief), rate_(rate), attributes_(attributes), shared_(surface, rate),
          evaluators_([&surface] { return std::make_unique<BaseSurface::Evaluator>(surface); }) {
        assert(rate >= smallestRate(surface) && rate <= kMaxRate && (rate & (rate - 1)) == 0);
    }

    MicroMesh build() {
        listFaces();
        allocate();
        sampleShared();
        tbb::parallel_for(size_t(0), faces_.size(), [&](size_t i) { fillFace(faces_[i]); });
        return std::move(mesh_);
    }

  private:
    struct Face {
        int face, firstPatch, patchCount;
        size_t firstVertex, firstGrid; // of its first patch
    };
    struct FaceEdge {
        int faceIndex, k; // into faces_; edge (or corner) of that face
    };

    void listFaces() {
        const auto& patches = surface_.patches();
        for (int p = 0; p < static_cast<int>(patches.size()); ++p) {
            const BaseSurface::Patch& patch = patches[static_cast<size_t>(p)];
            const MicroMeshSize size = patchLayoutSize(patch.triangular, patchRate(patch, rate_));
            if (faces_.empty() || faces_.back().face != patch.face)
                faces_.push_back({patch.face, p, 0, vertexCount_, gridCount_});
            ++faces_.back().patchCount;
            vertexCount_ += size.vertices;
            gridCount_ += size.grids;
            mesh_.microTriangleCount += size.microTriangles;
        }
    }

    void allocate() {
        mesh_.rate = rate_;
        mesh_.positionsWorld.reserve(vertexCount_ +
                                     1); // Embree reads 16 bytes at the last of its 12-byte items
        mesh_.positionsWorld.resize(vertexCount_);
        mesh_.grids.resize(gridCount_);
        if (attributes_) {
            mesh_.normalsWorld.resize(vertexCount_);
            mesh_.st.resize(vertexCount_);
        }
    }

    /// Compressed lists of the faces around each edge or each vertex.
    struct Incidence {
        std::vector<size_t> first;
        std::vector<FaceEdge> items;
    };
    template <typename ElementsOfFace>
    Incidence incidence(int elementCount, ElementsOfFace elementsOf) const {
        Incidence result;
        result.first.assign(static_cast<size_t>(elementCount) + 1, 0);
        for (const Face& face : faces_)
            for (const int element : elementsOf(face.face))
                ++result.first[static_cast<size_t>(element) + 1];
        for (size_t i = 1; i < result.first.size(); ++i)
            result.first[i] += result.first[i - 1];
        result.items.resize(result.first.back());
        std::vector<size_t> next = result.first;
        for (size_t f = 0; f < faces_.size(); ++f) {
            int k = 0;
            for (const int element : elementsOf(faces_[f].face))
                result.items[next[static_cast<size_t>(element)]++] = {static_cast<int>(f), k++};
        }
        return result;
    }

    /// Samples every vertex and every place on an edge once, from all the faces around it.
    void sampleShared() {
        sharedVertices_.resize(shared_.count());
        const Incidence edges =
            incidence(surface_.edgeCount(), [&](int face) { return surface_.faceEdges(face); });
        const Incidence corners =
            incidence(surface_.vertexCount(), [&](int face) { return surface_.faceVertices(face); });
        const auto around = [](const Incidence& lists, int element) {
            const size_t first = lists.first[static_cast<size_t>(element)];
            return std::span(lists.items)
                .subspan(first, lists.first[static_cast<size_t>(element) + 1] - first);
        };
        tbb::parallel_for(0, surface_.vertexCount(), [&](int vertex) {
            const std::span<const FaceEdge> faces = around(corners, vertex);
            if (!faces.empty())
                sampleSharedAt(static_cast<size_t>(vertex), faces, [](const FaceEdge&) { return 0; });
        });
        tbb::parallel_for(0, surface_.edgeCount(), [&](int edge) {
            const std::span<const FaceEdge> faces = around(edges, edge);
            if (faces.empty()) return;
            const FaceEdge& front = faces.front();
            const int face = faces_[static_cast<size_t>(front.faceIndex)].face;
            for (int step = 1; step < rate_; ++step) {
                const size_t number = shared_.onEdge(face, front.k, step);
                sampleSharedAt(number, faces, [&](const FaceEdge& side) {
                    return shared_.onEdge(faces_[static_cast<size_t>(side.faceIndex)].face, side.k, step) ==
                                   number
                               ? step
                               : rate_ - step;
                });
            }
        });
    }

    /// Position of the first face; displacement and its direction the mean over all faces.
    template <typename StepOf>
    void sampleSharedAt(size_t number, std::span<const FaceEdge> faces, StepOf stepOf) {
        BaseSurface::Evaluator& evaluator = *evaluators_.local();
        Vec3 position(0), direction(0);
        double distance = 0;
        for (size_t i = 0; i < faces.size(); ++i) {
            const Face& face = faces_[static_cast<size_t>(faces[i].faceIndex)];
            const int size = static_cast<int>(surface_.faceVertices(face.face).size());
            const auto at = edgePoint(surface_, face.firstPatch, size, faces[i].k, stepOf(faces[i]), rate_);
            evaluator.setPatch(at.patch);
            const BasePoint base = evaluator.point(at.u, at.v);
            const Vec2 st = textureCoordinates(base, relief_);
            direction += base.normal;
            distance += displacement(st, relief_);
            if (i > 0) continue;
            position = base.position;
            if (attributes_) {
                sharedVertices_[number].normal = displace(evaluator.sample(at.u, at.v), relief_).normal;
                sharedVertices_[number].st = st;
            }
        }
        const double length = glm::length(direction);
        if (length > 0) position += direction * (distance / (static_cast<double>(faces.size()) * length));
        sharedVertices_[number].position = position;
    }

    Vertex interior(double u, double v) {
        BaseSurface::Evaluator& evaluator = *evaluators_.local();
        Vertex vertex;
        if (attributes_) {
            const DisplacedSample sample = displace(evaluator.sample(u, v), relief_);
            vertex.normal = sample.normal;
            vertex.st = sample.st;
        }
        const BasePoint base = evaluator.point(u, v);
        vertex.position =
            base.position + base.normal * displacement(textureCoordinates(base, relief_), relief_);
        return vertex;
    }

    /// The patch's lattice of (cells + 1)^2 vertices, row by row; that of a triangle is used below its long
    /// side.
    struct Lattice {
        int cells = 0;
        bool triangular = false;
        std::vector<Vertex> vertices;
        Vertex& at(int column, int row) {
            return vertices[static_cast<size_t>(row) * static_cast<size_t>(cells + 1) +
                            static_cast<size_t>(column)];
        }
        /// Beyond a triangle's long side: the point on it in the same column, which leaves no area there.
        const Vertex& clamped(int column, int row) {
            if (!triangular || column + row <= cells) return at(column, row);
            return at(std::min(column, cells), cells - std::min(column, cells));
        }
    };

    void fillFace(const Face& face) {
        const BaseSurface::Patch& first = surface_.patches()[static_cast<size_t>(face.firstPatch)];
        Lattice lattice;
        lattice.cells = patchRate(first, rate_);
        lattice.triangular = first.triangular;
        lattice.vertices.resize(static_cast<size_t>(lattice.cells + 1) *
                                static_cast<size_t>(lattice.cells + 1));
        const std::vector<Vertex> spokes =
            first.subFace ? sampleSpokes(face, lattice.cells) : std::vector<Vertex>();
        const MicroMeshSize size = patchLayoutSize(first.triangular, lattice.cells);
        for (int k = 0; k < face.patchCount; ++k) {
            evaluators_.local()->setPatch(face.firstPatch + k);
            fillBorder(lattice, face, k, spokes);
            fillInterior(lattice);
            emit(lattice, face.firstPatch + k, face.firstVertex + static_cast<size_t>(k) * size.vertices,
                 face.firstGrid + static_cast<size_t>(k) * size.grids);
        }
    }

    /// Spoke k of a face split into sub-faces runs from the middle of edge k to the centre: cells vertices
    /// each, the centre (one for all) left out and put last.
    std::vector<Vertex> sampleSpokes(const Face& face, int cells) {
        std::vector<Vertex> spokes;
        for (int k = 0; k < face.patchCount; ++k) {
            evaluators_.local()->setPatch(face.firstPatch + k);
            spokes.push_back(sharedVertices_[shared_.onEdge(face.face, k, rate_ / 2)]);
            for (int j = 1; j < cells; ++j)
                spokes.push_back(interior(1, static_cast<double>(j) / cells));
        }
        spokes.push_back(interior(1, 1));
        return spokes;
    }

    void fillBorder(Lattice& lattice, const Face& face, int k, const std::vector<Vertex>& spokes) {
        const int n = lattice.cells;
        const auto edge = [&](int edgeOfFace, int step) -> const Vertex& {
            return sharedVertices_[shared_.onEdge(face.face, edgeOfFace, step)];
        };
        if (!spokes.empty()) {
            const int previous = (k + face.patchCount - 1) % face.patchCount;
            const auto spoke = [&](int which, int step) -> const Vertex& {
                return step == n ? spokes.back() : spokes[static_cast<size_t>(which * n + step)];
            };
            for (int i = 0; i <= n; ++i) {
                lattice.at(i, 0) = edge(k, i);
                lattice.at(0, i) = edge(previous, rate_ - i);
            }
            for (int i = 0; i <= n; ++i) {
                lattice.at(n, i) = spoke(k, i);
                lattice.at(i, n) = spoke(previous, i);
            }
            return;
        }
        for (int i = 0; i <= n; ++i) {
            lattice.at(i, 0) = edge(0, i);
            if (lattice.triangular) {
                lattice.at(n - i, i) = edge(1, i);
                lattice.at(0, n - i) = edge(2, i);
            } else {
                lattice.at(n, i) = edge(1, i);
                lattice.at(n - i, n) = edge(2, i);
                lattice.at(0, n - i) = edge(3, i);
            }
        }
    }

    void fillInterior(Lattice& lattice) {
        const int n = lattice.cells;
        for (int row = 1; row < n; ++row)
            for (int column = 1; column < (lattice.triangular ? n - row : n); ++column)
                lattice.at(column, row) =
                    interior(static_cast<double>(column) / n, static_cast<double>(row) / n);
    }

    /// Cuts a lattice into grids.
    void emit(Lattice& lattice, int patch, size_t vertex, size_t grid) {
        forEachBlock(lattice.triangular, lattice.cells, [&](int blockColumn, int blockRow) {
            const int column0 = blockColumn * kGridCells, row0 = blockRow * kGridCells;
            const int columns = blockCells(lattice.cells, blockColumn) + 1;
            const int rows = blockCells(lattice.cells, blockRow) + 1;
            mesh_.grids[grid++] = {static_cast<uint32_t>(vertex),  static_cast<uint32_t>(patch),
                                   static_cast<uint16_t>(columns), static_cast<uint16_t>(rows),
                                   static_cast<uint32_t>(column0), static_cast<uint32_t>(row0)};
            for (int row = row0; row < row0 + rows; ++row)
                for (int column = column0; column < column0 + columns; ++column)
                    store(vertex++, lattice.clamped(column, row));
        });
    }

    void store(size_t index, const Vertex& vertex) {
        mesh_.positionsWorld[index] = vertex.position;
        if (!attributes_) return;
        mesh_.normalsWorld[index] = vertex.normal;
        mesh_.st[index] = vertex.st;
    }

    const BaseSurface& surface_;
    const Relief* relief_;
    int rate_;
    bool attributes_;
    SharedSamples shared_;
    tbb::enumerable_thread_specific<std::unique_ptr<BaseSurface::Evaluator>> evaluators_;
    std::vector<Face> faces_;
    size_t vertexCount_ = 0, gridCount_ = 0;
    std::vector<Vertex> sharedVertices_;
    MicroMesh mesh_;
};

} // namespace

MicroMesh tessellate(const BaseSurface& surface, const Relief* relief, int rate, bool attributes) {
    return Tessellator(surface, relief, rate, attributes).build();
}

} // namespace plumbline
