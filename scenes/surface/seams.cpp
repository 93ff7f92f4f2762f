#include "scenes/surface/seams.h"

#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/patch_place.h"
#include "scenes/surface/weld.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace plumbline {
namespace {

/// Jumps of st within this distance of an integer, in texels, count as integer: single-precision exporters
/// leave errors of about 1e-7 of the largest coordinate, and maps have up to a few thousand texels per side.
constexpr double kWholeTexels = 1e-2;

constexpr int kMinPlaces = 32, kMaxPlaces = 2048;
/// Normals are compared at both ends of an edge and in between: they differ all along a crease, but only at
/// one end if the edge meets a corner.
constexpr int kNormalSegments = 4;

/// One face's use of an edge of the control mesh.
struct Side {
    int face, k;  // the face's edge from its corner k
    bool forward; // the face traverses the edge from its start
};

/// A face's normals along one of its edges, beginning at the edge's first corner. The last corner is stored
/// with the next edge.
using EdgeNormals = std::array<Vec3, kNormalSegments>;

class TearFinder {
  public:
    TearFinder(const BaseSurface& surface, const Relief& relief)
        : surface_(surface), mesh_(surface.mesh()), relief_(relief), sides_(lengthOf(surface.edgeCount())),
          faces_(mesh_.faces()) {
        for (int face = 0; face < mesh_.faceCount(); ++face)
            if (surface.hasLimit(face)) listSides(face);
    }

    TornEdges count() {
        evaluateNormals();
        std::vector<TornEdges> torn(sides_.size());
        tbb::parallel_for(size_t(0), sides_.size(), [&](size_t edge) {
            const std::vector<Side>& sides = sides_[edge];
            for (size_t i = 1; i < sides.size(); ++i) {
                torn[edge].byMap |= isTornByMap(sides[0], sides[i]);
                torn[edge].byNormals |= isTornByNormals(sides[0], sides[i]);
            }
        });
        TornEdges sum;
        for (const TornEdges& each : torn) {
            sum.byMap += each.byMap;
            sum.byNormals += each.byNormals;
        }
        return sum;
    }

  private:
    void listSides(int face) {
        const auto edges = surface_.faceEdges(face);
        const auto vertices = surface_.faceVertices(face);
        for (int k = 0; k < countOf(edges); ++k) {
            const int edge = item(edges, k);
            item(sides_, edge).push_back({face, k, item(vertices, k) == surface_.edgeStart(edge)});
        }
    }

    size_t cornerOf(const Side& side, int step) const { return cornerOf(side.face, side.k + step); }

    size_t cornerOf(int face, int k) const { return item(faces_, face).corner(lengthOf(k)); }

    /// st at the edge's start (0) or end (1); linear in between.
    Vec2 stAtEnd(const Side& side, int end) const {
        const size_t corner = cornerOf(side, side.forward ? end : 1 - end);
        return relief_.tile * mesh_.uvAt(corner) + relief_.uvOffset;
    }

    bool isTornByMap(const Side& a, const Side& b) const {
        const HeightMap& map = *relief_.map;
        const Vec2 texels(map.width(), map.height());
        const Vec2 a0 = stAtEnd(a, 0), a1 = stAtEnd(a, 1), b0 = stAtEnd(b, 0), b1 = stAtEnd(b, 1);
        if (joins(a0, b0, a1, b1)) return false;
        const double length = std::max(longest((a1 - a0) * texels), longest((b1 - b0) * texels));
        // Written so that an infinite length gives kMaxPlaces.
        const int places =
            2 * length < kMaxPlaces ? std::max(kMinPlaces, static_cast<int>(2 * length) + 1) : kMaxPlaces;
        for (int i = 0; i <= places; ++i) {
            const double t = double(i) / places;
            const double difference = map.depth(glm::mix(a0, a1, t)) - map.depth(glm::mix(b0, b1, t));
            if (std::abs(difference) * relief_.depth > kTornFraction * relief_.depth) return true;
        }
        return false;
    }

    static double longest(const Vec2& v) { return std::max(std::abs(v.x), std::abs(v.y)); }

    /// Whether both sides sample the same texels: st is continuous, or jumps at both ends by the same integer
    /// along an axis that repeats.
    bool joins(const Vec2& a0, const Vec2& b0, const Vec2& a1, const Vec2& b1) const {
        const HeightMap& map = *relief_.map;
        const auto joinsAlong = [&](int axis, Wrap wrap, int size) {
            const double jump = a0[axis] - b0[axis], tolerance = kWholeTexels / size;
            const double whole = wrap == Wrap::Repeat ? std::round(jump) : 0;
            return std::abs(jump - whole) <= tolerance && std::abs(a1[axis] - b1[axis] - whole) <= tolerance;
        };
        return joinsAlong(0, map.wrapS(), map.width()) && joinsAlong(1, map.wrapT(), map.height());
    }

    /// Each face's patches are set up once for all of its edges, because the setup costs more than the
    /// samples.
    void evaluateNormals() {
        normals_.resize(mesh_.faceVertices.size());
        tbb::parallel_for(tbb::blocked_range<int>(0, mesh_.faceCount(), 8),
                          [&](const tbb::blocked_range<int>& faces) {
                              BaseSurface::Evaluator evaluator(surface_);
                              for (int face = faces.begin(); face < faces.end(); ++face)
                                  if (surface_.hasLimit(face)) evaluateNormals(face, evaluator);
                          });
    }

    void evaluateNormals(int face, BaseSurface::Evaluator& evaluator) {
        for (int k = 0; k < item(mesh_.faceSizes, face); ++k)
            for (int i = 0; i < kNormalSegments; ++i) {
                const PatchPlace place = placeOnEdge(surface_, face, k, double(i) / kNormalSegments);
                evaluator.setPatch(place.patch);
                item(normals_[cornerOf(face, k)], i) = evaluator.point(place.uv.x, place.uv.y).normal;
            }
    }

    /// The normal at step `place` of kNormalSegments along the edge, from its start.
    const Vec3& normalAt(const Side& side, int place) const {
        const int along = side.forward ? place : kNormalSegments - place;
        return along < kNormalSegments ? item(normals_[cornerOf(side, 0)], along)
                                       : normals_[cornerOf(side, 1)][0];
    }

    bool isTornByNormals(const Side& a, const Side& b) const {
        if (relief_.axisWorld) return false; // both displace along it
        const Vec2 a0 = stAtEnd(a, 0), a1 = stAtEnd(a, 1);
        const double size = std::max(relief_.depth, std::abs(relief_.offset));
        for (int i = 0; i <= kNormalSegments; ++i) {
            const double t = double(i) / kNormalSegments;
            const double height = displacement(glm::mix(a0, a1, t), &relief_);
            if (glm::length(normalAt(a, i) - normalAt(b, i)) * std::abs(height) > kTornFraction * size)
                return true;
        }
        return false;
    }

    const BaseSurface& surface_;
    const ControlMesh& mesh_;
    const Relief& relief_;
    std::vector<std::vector<Side>> sides_; // of each edge
    std::vector<MeshFace> faces_;
    std::vector<EdgeNormals> normals_; // per face corner: along the edge that begins there
};

void report(std::vector<std::string>& warnings, const SceneObject& object, int edges, const char* cause) {
    if (edges == 0) return;
    warnings.push_back(fmt::format(
        "{}: {} {} where {} tear the surface; {}", object.name, edges, edges == 1 ? "edge" : "edges", cause,
        object.relief->seams == Seams::Weld ? "welded at the mean displacement (seams = \"weld\")"
                                            : "left open (seams = \"open\")"));
}

} // namespace

TornEdges countTornEdges(const BaseSurface& surface, const Relief& relief) {
    assert(surface.mesh().hasUvs());
    return TearFinder(surface, relief).count();
}

std::vector<std::string> surfaceWarnings(const SceneObject& object, const BaseSurface& surface) {
    std::vector<std::string> warnings;
    if (!object.relief) return warnings;
    const TornEdges torn = countTornEdges(surface, *object.relief);
    report(warnings, object, torn.byMap, "texture coordinates");
    report(warnings, object, torn.byNormals, "normals");
    return warnings;
}

} // namespace plumbline
