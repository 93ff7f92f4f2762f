#include "rate.h"

#include "../scenes/displaced_surface.h"
#include "../scenes/error.h"
#include "lattice.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {

namespace {

// Pieces of an edge whose length on screen is measured one by one: enough to follow a curved edge and
// perspective.
constexpr int kPiecesPerEdge = 4;
// Pieces this far outside the picture, in pictures, can still come into it when displaced.
constexpr double kPictureMargin = 0.25;

/// Texels an edge of the mesh crosses, the larger of both directions.
double longestEdgeTexels(const ControlMesh& mesh, const Relief& relief) {
    double longest = 0;
    size_t first = 0;
    for (const int faceSize : mesh.faceSizes) {
        const size_t size = static_cast<size_t>(faceSize);
        for (size_t k = 0; k < size; ++k) {
            const Vec2 along = mesh.uvs[static_cast<size_t>(mesh.faceUvs[first + (k + 1) % size])] -
                               mesh.uvs[static_cast<size_t>(mesh.faceUvs[first + k])];
            const Vec2 texels =
                glm::abs(relief.tile * along) * Vec2(relief.map->width(), relief.map->height());
            longest = std::max({longest, texels.x, texels.y});
        }
        first += size;
    }
    return longest;
}

/// Length in pixels of a short piece, as if it lay across the line of sight; 0 if it is out of the picture.
double piecePixels(const Camera& camera, const CameraRays& rays, const Vec3& a, const Vec3& b) {
    const double length = glm::length(b - a);
    if (camera.projection == Camera::Projection::Orthographic)
        return length * camera.height / camera.viewHeight;
    const double depthA = rays.planarDepth(a), depthB = rays.planarDepth(b);
    if (depthA <= 0 && depthB <= 0) return 0;
    const double nearest = std::max(std::min(depthA, depthB), length); // no nearer than its own length
    if (depthA > 0 && depthB > 0) {
        const Vec3 pixelA = pixelFromWorld(camera, a), pixelB = pixelFromWorld(camera, b);
        const Vec2 margin = kPictureMargin * Vec2(camera.width, camera.height);
        const Vec2 low = glm::min(Vec2(pixelA), Vec2(pixelB)), high = glm::max(Vec2(pixelA), Vec2(pixelB));
        if (low.x > camera.width + margin.x || low.y > camera.height + margin.y || high.x < -margin.x ||
            high.y < -margin.y)
            return 0;
    }
    return length * camera.height / (2 * std::tan(radians(camera.fovYDegrees) / 2)) / nearest;
}

/// Length on screen of the longest edge, in pixels, were it as long everywhere as its longest piece.
double longestEdgePixels(const BaseSurface& surface, const Camera& camera) {
    const CameraRays rays(camera);
    BaseSurface::Evaluator evaluator(surface);
    double longest = 0;
    for (int face = 0; face < surface.mesh().faceCount(); ++face) {
        if (!surface.hasLimit(face)) continue;
        const BaseSurface::FaceTessellation cut = surface.tessellateFace(face, kPiecesPerEdge);
        std::vector<Vec3> points;
        for (const auto& sample : cut.samples) {
            evaluator.setPatch(sample.patch);
            points.push_back(evaluator.point(sample.u, sample.v).position);
        }
        for (const std::array<int, 4>& facet : cut.facets)
            for (size_t k = 0; k < 4; ++k) {
                if (facet[3] < 0) break; // the odd triangle in the middle of a face has no other lengths
                longest = std::max(longest, piecePixels(camera, rays, points[static_cast<size_t>(facet[k])],
                                                        points[static_cast<size_t>(facet[(k + 1) % 4])]));
            }
    }
    return longest * kPiecesPerEdge;
}

/// Whether the coarsest tessellation already is the surface: polygons as they are, without relief, all of them parallelograms, on
/// which (u,v) is linear. `mesh` may be turned and scaled, so opposite corners meet but for rounding.
bool isExactWhenCoarse(const ControlMesh& mesh, const SceneObject& object) {
    if (object.scheme != Scheme::None || object.relief) return false;
    const auto corner = [&](size_t i) { return mesh.points[static_cast<size_t>(mesh.faceVertices[i])]; };
    for (size_t face = 0; face < mesh.faceSizes.size(); ++face) {
        if (mesh.faceSizes[face] != 4) return false;
        const Vec3 a = corner(4 * face), b = corner(4 * face + 1), c = corner(4 * face + 2),
                   d = corner(4 * face + 3);
        const double size = glm::length(c - a) + glm::length(d - b);
        const double largest = std::max(glm::length(a), glm::length(c));
        if (glm::length((a + c) - (b + d)) > 0x1p-40 * (size + largest)) return false;
    }
    return true;
}

int powerOfTwoAtLeast(double value) {
    int power = 1;
    while (power < value && power < kMostRate)
        power *= 2;
    return power;
}

} // namespace

int wantedRate(const BaseSurface& surface, const SceneObject& object, const Camera& camera) {
    if (isExactWhenCoarse(surface.mesh(), object)) return smallestRate(surface);
    double segments = 2 * longestEdgePixels(surface, camera);
    if (object.relief && object.relief->depth > 0)
        segments = std::max(segments, 2 * longestEdgeTexels(surface.mesh(), *object.relief));
    return std::max(powerOfTwoAtLeast(segments), smallestRate(surface));
}

std::vector<int> ratesWithinMemory(const std::vector<const BaseSurface*>& surfaces, std::vector<int> rates,
                                   uint64_t memoryBytes) {
    for (;;) {
        double bytes = 0;
        size_t largest = surfaces.size();
        uint64_t mostTriangles = 0;
        for (size_t i = 0; i < surfaces.size(); ++i) {
            const uint64_t triangles =
                microMeshSize(*surfaces[i], uniformRates(*surfaces[i], rates[i])).microTriangles;
            bytes += kBytesPerMicroTriangle * static_cast<double>(triangles);
            if (triangles > mostTriangles && rates[i] > smallestRate(*surfaces[i])) {
                mostTriangles = triangles;
                largest = i;
            }
        }
        if (bytes <= static_cast<double>(memoryBytes)) return rates;
        if (largest == surfaces.size())
            throw MachineError("--memory",
                               fmt::format("{} MB don't hold the scene even at its coarsest tessellation",
                                           memoryBytes >> 20),
                               fmt::format("at least {:.0f} MB", bytes / (1 << 20) + 1));
        rates[largest] /= 2;
    }
}

} // namespace plumbline
