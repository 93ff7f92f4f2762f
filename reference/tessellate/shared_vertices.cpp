#include "reference/tessellate/shared_vertices.h"

#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/patch_place.h"
#include "scenes/surface/weld.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <memory>

namespace plumbline {

namespace {

// Under Seams::Open, faces agree about a vertex if their positions differ by less than this fraction of its
// coordinates: far above the rounding errors of two evaluations (2^-50) and below the resolution of a float.
constexpr double kSamePlace = 0x1p-30;

/// One face's evaluation of a shared vertex.
struct FaceSample {
    Vec3 position;       // of the base
    Vec3 direction;      // of the displacement, unit
    double displacement; // along it
    Vec2 st;
    Vec3 displaced() const { return position + direction * displacement; }
};

/// The first face's base position, displaced by the mean displacement of the sides along their mean
/// direction.
Vec3 meanPosition(const std::vector<FaceSample>& samples, const Relief* relief) {
    std::vector<Displacement> ofFaces;
    for (const FaceSample& sample : samples)
        ofFaces.push_back({sample.direction, sample.displacement});
    const std::vector<Displacement> sides = weldedSides(std::move(ofFaces), relief ? relief->depth : 0);
    Vec3 direction(0);
    double displacement = 0;
    for (const Displacement& side : sides) {
        direction += side.direction;
        displacement += side.height;
    }
    const double length = glm::length(direction);
    if (!(length > 0)) return samples[0].position;
    return samples[0].position + direction * (displacement / (static_cast<double>(sides.size()) * length));
}

bool agree(const FaceSample& a, const FaceSample& b) {
    const Vec3 p = a.displaced(), q = b.displaced();
    return glm::length(p - q) <= kSamePlace * (glm::length(p) + glm::length(q));
}

} // namespace

class SharedVertexBuilder {
  public:
    SharedVertexBuilder(SharedVertices& shared, const Relief* relief, const Rates& rates, bool attributes)
        : shared_(shared), surface_(shared.surface_), relief_(relief), rates_(rates), attributes_(attributes),
          open_(relief && relief->seams == Seams::Open),
          evaluators_([this] { return std::make_unique<BaseSurface::Evaluator>(surface_); }) {}

    void build() {
        listFaces();
        shared_.vertices_.resize(shared_.samples_.count() + placeSpokes());
        sampleMesh();
        tbb::parallel_for(size_t(0), faces_.size(), [&](size_t f) { sampleSpokes(faces_[f]); });
    }

  private:
    struct Face {
        int face, size;
    };
    struct FaceEdge {
        int faceIndex, k; // into faces_; edge (or corner) of that face
    };
    /// Compressed lists of the faces around each edge or each vertex.
    struct Incidence {
        std::vector<size_t> first;
        std::vector<FaceEdge> items;
        std::span<const FaceEdge> around(int element) const {
            const size_t begin = item(first, element);
            return std::span(items).subspan(begin, item(first, element + 1) - begin);
        }
    };

    void listFaces() {
        for (int face = 0; face < surface_.mesh().faceCount(); ++face)
            if (surface_.hasLimit(face)) faces_.push_back({face, countOf(surface_.faceVertices(face))});
        if (!open_) return;
        shared_.meshFaces_ = surface_.mesh().faces();
        shared_.ownVertices_.resize(surface_.mesh().faceVertices.size());
    }

    const Face& faceOf(const FaceEdge& side) const { return item(faces_, side.faceIndex); }

    bool isCut(const Face& face) const { return surface_.patch(surface_.firstPatch(face.face)).subFace; }

    /// Numbers the vertices of all spokes after those of the mesh; returns the total count.
    size_t placeSpokes() {
        const size_t faceCount = surface_.mesh().faceSizes.size();
        shared_.faceRates_.assign(faceCount, 0);
        shared_.spokes_.assign(faceCount, {0, 0});
        size_t count = 0;
        for (const Face& face : faces_) {
            if (!isCut(face)) continue;
            const int rate = item(rates_.faces, face.face).x;
            const size_t first = shared_.samples_.count() + count, ofSpokes = areaOf(rate / 2, face.size);
            item(shared_.faceRates_, face.face) = rate;
            item(shared_.spokes_, face.face) = {first, first + ofSpokes};
            count += ofSpokes + 1;
        }
        return count;
    }

    template <typename ElementsOfFace>
    Incidence incidence(int elementCount, ElementsOfFace elementsOf) const {
        Incidence result;
        result.first.assign(lengthOf(elementCount + 1), 0);
        for (const Face& face : faces_)
            for (const int element : elementsOf(face.face))
                ++item(result.first, element + 1);
        for (size_t i = 1; i < result.first.size(); ++i)
            result.first[i] += result.first[i - 1];
        result.items.resize(result.first.back());
        std::vector<size_t> next = result.first;
        for (int f = 0; f < countOf(faces_); ++f) {
            int k = 0;
            for (const int element : elementsOf(item(faces_, f).face))
                result.items[item(next, element)++] = {f, k++};
        }
        return result;
    }

    /// Evaluates every vertex and every sample on an edge from all incident faces.
    void sampleMesh() {
        const Incidence edges =
            incidence(surface_.edgeCount(), [&](int face) { return surface_.faceEdges(face); });
        const Incidence corners =
            incidence(surface_.vertexCount(), [&](int face) { return surface_.faceVertices(face); });
        const auto sampleVertex = [&](int vertex) {
            const std::span<const FaceEdge> faces = corners.around(vertex);
            if (!faces.empty()) samplePlace(lengthOf(vertex), faces, [](const FaceEdge&) { return 0; });
        };
        const auto sampleEdge = [&](int edge) {
            const std::span<const FaceEdge> faces = edges.around(edge);
            if (faces.empty()) return;
            const int rate = item(rates_.edges, edge);
            const int face = faceOf(faces.front()).face;
            for (int step = 1; step < rate; ++step) {
                const size_t number = shared_.samples_.onEdge(face, faces.front().k, step);
                samplePlace(number, faces, [&](const FaceEdge& side) {
                    const int of = faceOf(side).face;
                    return shared_.samples_.onEdge(of, side.k, step) == number ? step : rate - step;
                });
            }
        };
        if (open_) { // separate vertices are appended in an order that must not depend on the threads
            for (int vertex = 0; vertex < surface_.vertexCount(); ++vertex)
                sampleVertex(vertex);
            for (int edge = 0; edge < surface_.edgeCount(); ++edge)
                sampleEdge(edge);
            return;
        }
        tbb::parallel_for(0, surface_.vertexCount(), sampleVertex);
        tbb::parallel_for(0, surface_.edgeCount(), sampleEdge);
    }

    template <typename StepOf>
    void samplePlace(size_t number, std::span<const FaceEdge> faces, StepOf stepOf) {
        std::vector<FaceSample> samples;
        samples.reserve(faces.size());
        MicroVertex vertex;
        for (const FaceEdge& side : faces) {
            const PatchPlace at = pointOf(side, stepOf(side));
            samples.push_back(sampleAt(at));
            if (samples.size() == 1) vertex = makeVertex(at, samples[0]);
        }
        vertex.position = Vec3f(meanPosition(samples, relief_));
        shared_.vertices_[number] = vertex;
        if (open_) openPlace(number, faces, samples, stepOf);
    }

    PatchPlace pointOf(const FaceEdge& side, int step) const {
        const Face& face = faceOf(side);
        const int edge = item(surface_.faceEdges(face.face), side.k);
        const int rate = item(rates_.edges, edge);
        return placeOnEdge(surface_, face.face, side.k, double(step) / rate);
    }

    FaceSample sampleAt(const PatchPlace& at) {
        BaseSurface::Evaluator& evaluator = *evaluators_.local();
        evaluator.setPatch(at.patch);
        const BasePoint base = evaluator.point(at.uv.x, at.uv.y);
        const Vec2 st = textureCoordinates(base, relief_);
        return {base.position, reliefDirection(base, relief_), displacement(st, relief_), st};
    }

    /// The evaluator must be set to the patch of `at`.
    MicroVertex makeVertex(const PatchPlace& at, const FaceSample& sample) {
        MicroVertex vertex;
        if (!attributes_) return vertex;
        const BaseSample base = evaluators_.local()->sample(at.uv.x, at.uv.y);
        vertex.normal = displace(base, relief_).normal;
        vertex.baseNormal = base.normal;
        vertex.st = sample.st;
        return vertex;
    }

    /// Faces that agree with the first one share the vertex, at their mean; each other group of agreeing
    /// faces gets a separate vertex.
    template <typename StepOf>
    void openPlace(size_t number, std::span<const FaceEdge> faces, const std::vector<FaceSample>& samples,
                   StepOf stepOf) {
        std::vector<size_t> vertexOf(faces.size(), 0);
        std::vector<bool> done(faces.size(), false);
        for (size_t i = 0; i < faces.size(); ++i) {
            if (done[i]) continue;
            std::vector<FaceSample> group;
            const size_t target = i == 0 ? number : shared_.vertices_.size();
            for (size_t j = i; j < faces.size(); ++j) {
                if (done[j] || !agree(samples[i], samples[j])) continue;
                done[j] = true;
                group.push_back(samples[j]);
                vertexOf[j] = target;
            }
            const PatchPlace at = pointOf(faces[i], stepOf(faces[i]));
            evaluators_.local()->setPatch(at.patch);
            MicroVertex vertex = makeVertex(at, samples[i]);
            vertex.position = Vec3f(meanPosition(group, relief_));
            if (i > 0) shared_.vertices_.emplace_back();
            shared_.vertices_[target] = vertex;
        }
        for (size_t i = 0; i < faces.size(); ++i) {
            if (vertexOf[i] == number) continue;
            shared_.ownVerticesAt(faceOf(faces[i]).face, faces[i].k)
                .emplace_back(stepOf(faces[i]), vertexOf[i]);
        }
    }

    /// Spoke k runs from the midpoint of edge k, which is a sample of the mesh, to the center.
    void sampleSpokes(const Face& face) {
        const int cells = item(shared_.faceRates_, face.face) / 2;
        if (cells == 0) return;
        const int first = surface_.firstPatch(face.face);
        const SharedVertices::Spokes spokes = item(shared_.spokes_, face.face);
        for (int k = 0; k < face.size; ++k)
            for (int step = 1; step < cells; ++step)
                shared_.vertices_[spokes.first + indexIn(cells, step, k)] =
                    vertexInside({first + k, {1, double(step) / cells}});
        shared_.vertices_[spokes.center] = vertexInside({first, {1, 1}});
    }

    MicroVertex vertexInside(const PatchPlace& at) {
        const FaceSample sample = sampleAt(at);
        MicroVertex vertex = makeVertex(at, sample);
        vertex.position = Vec3f(sample.displaced());
        return vertex;
    }

    SharedVertices& shared_;
    const BaseSurface& surface_;
    const Relief* relief_;
    const Rates& rates_;
    bool attributes_, open_;
    tbb::enumerable_thread_specific<std::unique_ptr<BaseSurface::Evaluator>> evaluators_;
    std::vector<Face> faces_;
};

SharedVertices::SharedVertices(const BaseSurface& surface, const Relief* relief, const Rates& rates,
                               bool attributes)
    : surface_(surface), samples_(surface, rates.edges) {
    SharedVertexBuilder(*this, relief, rates, attributes).build();
}

SharedVertices::OwnVertices& SharedVertices::ownVerticesAt(int face, int k) {
    return ownVertices_[item(meshFaces_, face).corner(lengthOf(k))];
}

size_t SharedVertices::onEdge(int face, int k, int step) const {
    if (!meshFaces_.empty()) {
        // A corner belongs to the edge that starts there.
        const int rate = samples_.edgeRate(item(surface_.faceEdges(face), k));
        const int corner = step == rate ? k + 1 : k, at = step == rate ? 0 : step;
        for (const auto& [ownStep, vertex] : ownVertices_[item(meshFaces_, face).corner(lengthOf(corner))])
            if (ownStep == at) return vertex;
    }
    return samples_.onEdge(face, k, step);
}

size_t SharedVertices::onSpoke(int face, int spoke, int step) const {
    const int cells = item(faceRates_, face) / 2;
    const Spokes& spokes = item(spokes_, face);
    if (step == cells) return spokes.center;
    if (step > 0) return spokes.first + indexIn(cells, step, spoke);
    return onEdge(face, spoke, samples_.edgeRate(item(surface_.faceEdges(face), spoke)) / 2);
}

const MicroVertex& SharedVertices::at(int patchIndex, int side, int segment) const {
    const BaseSurface::Patch& patch = surface_.patch(patchIndex);
    const std::span<const int> edges = surface_.faceEdges(patch.face);
    const auto backwards = [&](int k) { return samples_.edgeRate(item(edges, k)) - segment; };
    if (patch.subFace) {
        const int size = countOf(edges), previous = (patch.corner + size - 1) % size;
        switch (side) {
        case 0:
            return vertices_[onEdge(patch.face, patch.corner, segment)];
        case 1:
            return vertices_[onSpoke(patch.face, patch.corner, segment)];
        case 2:
            return vertices_[onSpoke(patch.face, previous, segment)];
        default:
            return vertices_[onEdge(patch.face, previous, backwards(previous))];
        }
    }
    const bool forwards = side < 2; // edges 0 and 1 run with u and v, the others against them
    return vertices_[onEdge(patch.face, side, forwards ? segment : backwards(side))];
}

} // namespace plumbline
