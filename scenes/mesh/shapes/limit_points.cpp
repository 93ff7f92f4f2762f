#include "scenes/mesh/shapes/limit_points.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace plumbline {
namespace {

struct Edge {
    int low, high;            // vertices
    int face, otherFace = -1; // -1: on the boundary
};

/// The mask of limitPoints for one topology, applied to any points.
class LimitMask {
  public:
    explicit LimitMask(const ControlMesh& mesh)
        : mesh_(mesh), faces_(mesh.faces()), faceCounts_(mesh.points.size()) {
        std::vector<Edge> halves;
        for (const MeshFace& face : faces_)
            for (size_t k = 0; k < face.size; ++k) {
                const int a = mesh.faceVertices[face.corner(k)], b = mesh.faceVertices[face.corner(k + 1)];
                halves.push_back({std::min(a, b), std::max(a, b), face.index});
                ++item(faceCounts_, a);
            }
        std::ranges::sort(halves, [](const Edge& x, const Edge& y) {
            return std::tie(x.low, x.high, x.face) < std::tie(y.low, y.high, y.face);
        });
        for (const Edge& half : halves) {
            const bool second =
                !edges_.empty() && edges_.back().low == half.low && edges_.back().high == half.high;
            assert(!second || edges_.back().otherFace < 0);
            if (second)
                edges_.back().otherFace = half.face;
            else
                edges_.push_back(half);
        }
    }

    std::vector<Vec3> apply(const std::vector<Vec3>& points) const {
        const std::vector<Vec3> facePoints = centroids(points);
        std::vector<Ring> rings(points.size());
        for (const MeshFace& face : faces_)
            for (const int vertex : face.of(mesh_.faceVertices))
                item(rings, vertex).faces += item(facePoints, face.index);
        for (const Edge& edge : edges_)
            gather(edge, points, facePoints, rings);
        std::vector<Vec3> limits(points.size());
        for (size_t v = 0; v < points.size(); ++v)
            limits[v] = limit(points[v], rings[v], faceCounts_[v]);
        return limits;
    }

  private:
    struct Ring {
        Vec3 neighbors{0};       // sum over the edges of the vertex at the other end
        Vec3 edges{0}, faces{0}; // sums of the refined edge and face points
        Vec3 boundary{0};        // sum of the two neighbors along the boundary
        int boundaryEdges = 0;
    };

    std::vector<Vec3> centroids(const std::vector<Vec3>& points) const {
        std::vector<Vec3> result;
        for (const MeshFace& face : faces_) {
            Vec3 sum(0);
            for (const int vertex : face.of(mesh_.faceVertices))
                sum += item(points, vertex);
            result.push_back(sum / static_cast<double>(face.size));
        }
        return result;
    }

    static void gather(const Edge& edge, const std::vector<Vec3>& points, const std::vector<Vec3>& facePoints,
                       std::vector<Ring>& rings) {
        const Vec3 &low = item(points, edge.low), &high = item(points, edge.high);
        Ring &ofLow = item(rings, edge.low), &ofHigh = item(rings, edge.high);
        if (edge.otherFace < 0) {
            ofLow.boundary += high;
            ofHigh.boundary += low;
            ++ofLow.boundaryEdges;
            ++ofHigh.boundaryEdges;
            return;
        }
        const Vec3 edgePoint =
            0.25 * (low + high + item(facePoints, edge.face) + item(facePoints, edge.otherFace));
        ofLow.neighbors += high;
        ofHigh.neighbors += low;
        ofLow.edges += edgePoint;
        ofHigh.edges += edgePoint;
    }

    static Vec3 limit(const Vec3& point, const Ring& ring, int valence) {
        if (valence == 0) return point; // not used by any face
        if (ring.boundaryEdges > 0) return valence == 1 ? point : (ring.boundary + 4.0 * point) / 6.0;
        const double n = valence;
        const Vec3 refined = ((n - 2) / n) * point + (ring.neighbors + ring.faces) / (n * n);
        return (n * n * refined + 4.0 * ring.edges + ring.faces) / (n * (n + 5));
    }

    const ControlMesh& mesh_;
    std::vector<MeshFace> faces_;
    std::vector<Edge> edges_;
    std::vector<int> faceCounts_; // per vertex; inside the mesh this is the valence
};

} // namespace

std::vector<Vec3> limitPoints(const ControlMesh& mesh) {
    return LimitMask(mesh).apply(mesh.points);
}

void interpolateLimit(ControlMesh& mesh) {
    constexpr double kTolerance = 1e-12; // of the mesh's size; the sums above round at about 1e-15
    // Chebyshev iteration (Golub, Varga 1961) on limits(points) = targets. The mask's eigenvalues are at most
    // 1, because its weights are positive and sum to 1, and at least ((4 - 2)/6)^2 = 1/9 on a regular grid,
    // somewhat less near extraordinary vertices. With 1/16 as the lower bound, each step reduces the error to
    // 0.6 of its value; an error of 1e-12 takes about 55 steps.
    constexpr double kLeast = 1.0 / 16, kMost = 1, kMiddle = (kMost + kLeast) / 2,
                     kHalf = (kMost - kLeast) / 2;
    constexpr int kMaxSteps = 400;
    const LimitMask mask(mesh);
    const std::vector<Vec3> targets = mesh.points;
    Bounds bounds;
    for (const Vec3& target : targets)
        bounds.add(target);
    std::vector<Vec3> moves(targets.size(), Vec3(0));
    double rho = 0; // rho and the two factors are the recurrence of the Chebyshev polynomials' ratios
    for (int step = 0; step < kMaxSteps; ++step) {
        const std::vector<Vec3> limits = mask.apply(mesh.points);
        const double next = step == 0 ? kHalf / kMiddle : 1 / (2 * kMiddle / kHalf - rho);
        const double keep = step == 0 ? 0 : next * rho, gain = step == 0 ? 1 / kMiddle : 2 * next / kHalf;
        rho = next;
        double worst = 0;
        for (size_t v = 0; v < targets.size(); ++v) {
            const Vec3 missing = targets[v] - limits[v];
            worst = std::max(worst, glm::length(missing));
            moves[v] = keep * moves[v] + gain * missing;
        }
        if (worst <= kTolerance * bounds.diagonal()) return;
        for (size_t v = 0; v < targets.size(); ++v)
            mesh.points[v] += moves[v];
    }
    assert(!"the limit mask of a built-in shape is not within its bounds");
}

} // namespace plumbline
