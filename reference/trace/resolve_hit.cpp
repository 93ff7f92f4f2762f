#include "reference/trace/resolve_hit.h"

#include "reference/tessellate/lattice.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

/// One micro-triangle of a cell: `corner` and the edges to the adjacent vertices at +-1 column and +-1 row.
struct Triangle {
    Vec3 corner, alongColumn, alongRow; // the latter two are edges
    int column, row, sign;              // lattice position of the corner; sign of both steps
};

// Relative error of Embree's distance, up to 1e-5 (measured); smaller differences can't distinguish two
// surfaces.
constexpr double kDistanceError = 1e-5;

/// The point of a micro-triangle nearest to a hit.
struct Candidate {
    Triangle triangle;
    double beta = 0, gamma = 0;
    Vec3 position{0};
    double distance = 0;
    /// World units: the distance of the ray from the point plus the difference to Embree's distance beyond
    /// its error. 0 for a ray that hits the triangle at Embree's distance. So a triangle missed by rounding
    /// is preferred to a triangle hit at another distance.
    double mismatch = kInfinity;
};

/// Moeller and Trumbore 1997, in double. Rays through an edge may miss all triangles by rounding, so the
/// nearest point of the triangle is used (clamped one coordinate after the other, which is sufficient for
/// such small distances).
Candidate intersect(const Triangle& triangle, const Ray& ray, double distance) {
    Candidate hit;
    hit.triangle = triangle;
    const Vec3 p = glm::cross(ray.direction, triangle.alongRow);
    const double determinant = glm::dot(triangle.alongColumn, p);
    if (determinant == 0) return hit;
    const Vec3 s = ray.origin - triangle.corner;
    const Vec3 q = glm::cross(s, triangle.alongColumn);
    const double beta = glm::dot(s, p) / determinant, gamma = glm::dot(ray.direction, q) / determinant;
    hit.beta = std::clamp(beta, 0.0, 1.0);
    hit.gamma = std::clamp(gamma, 0.0, 1.0 - hit.beta);
    hit.position = triangle.corner + hit.beta * triangle.alongColumn + hit.gamma * triangle.alongRow;
    const Vec3 fromOrigin = hit.position - ray.origin;
    hit.distance = glm::dot(fromOrigin, ray.direction);
    const bool inside = hit.beta == beta && hit.gamma == gamma;
    hit.mismatch = (inside ? 0 : glm::length(fromOrigin - hit.distance * ray.direction)) +
                   std::max(0.0, std::abs(hit.distance - distance) - kDistanceError * std::abs(distance));
    return hit;
}

bool better(const Candidate& a, const Candidate& b, double distance) {
    if (a.mismatch != b.mismatch) return a.mismatch < b.mismatch;
    return std::abs(a.distance - distance) < std::abs(b.distance - distance);
}

Triangle triangleOf(const MicroMesh& mesh, const MicroGrid& grid, int column, int row, bool upper) {
    const auto vertex = [&](int c, int r) { return Vec3(mesh.positionsWorld[grid.vertex(c, r)]); };
    const Vec3 b = vertex(column + 1, row), c = vertex(column, row + 1);
    if (!upper) {
        const Vec3 a = vertex(column, row);
        return {a, b - a, c - a, grid.column0 + column, grid.row0 + row, 1};
    }
    const Vec3 d = vertex(column + 1, row + 1);
    return {d, c - d, b - d, grid.column0 + column + 1, grid.row0 + row + 1, -1};
}

} // namespace

ResolvedHit resolveHit(const MicroMesh& mesh, const MicroGrid& grid, float u, float v, float distance,
                       const Ray& ray) {
    const int cellColumns = grid.columns - 1, cellRows = grid.rows - 1;
    const double x = double(u) * cellColumns, y = double(v) * cellRows;
    const int column = std::clamp(static_cast<int>(x), 0, cellColumns - 1);
    const int row = std::clamp(static_cast<int>(y), 0, cellRows - 1);

    Candidate hit =
        intersect(triangleOf(mesh, grid, column, row, (x - column) + (y - row) > 1), ray, distance);
    if (hit.mismatch > 0) {
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, cellRows - 1); ++r)
            for (int c = std::max(column - 1, 0); c <= std::min(column + 1, cellColumns - 1); ++c)
                for (const bool upper : {false, true}) {
                    const Candidate other = intersect(triangleOf(mesh, grid, c, r, upper), ray, distance);
                    if (better(other, hit, distance)) hit = other;
                }
    }
    const Triangle& triangle = hit.triangle;
    ResolvedHit result;
    result.position = hit.position;
    result.distance = hit.distance;
    result.facetNormal = glm::normalize(glm::cross(triangle.alongColumn, triangle.alongRow));
    const PatchLattice& lattice = mesh.lattices[grid.patch];
    const Vec2 corner = latticeUv(lattice, triangle.column, triangle.row);
    result.uv = corner +
                hit.beta * (latticeUv(lattice, triangle.column + triangle.sign, triangle.row) - corner) +
                hit.gamma * (latticeUv(lattice, triangle.column, triangle.row + triangle.sign) - corner);
    return result;
}

} // namespace plumbline
