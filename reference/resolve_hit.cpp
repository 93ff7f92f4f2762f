#include "resolve_hit.h"

#include "lattice.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

/// One micro-triangle of a cell: `corner`, then the two reached along +-1 column and +-1 row.
struct Triangle {
    Vec3 corner, alongColumn, alongRow; // the latter two are edges
    int column, row, sign;              // lattice place of the corner; sign of both steps
};

struct Intersection {
    double beta = 0, gamma = 0, distance = 0;
    double inside = -kInfinity; // smallest barycentric coordinate: >= 0 inside
};

/// Moeller and Trumbore 1997, in double.
Intersection intersect(const Triangle& triangle, const Ray& ray) {
    const Vec3 p = glm::cross(ray.direction, triangle.alongRow);
    const double determinant = glm::dot(triangle.alongColumn, p);
    if (determinant == 0) return {};
    const Vec3 s = ray.origin - triangle.corner;
    const Vec3 q = glm::cross(s, triangle.alongColumn);
    Intersection hit;
    hit.beta = glm::dot(s, p) / determinant;
    hit.gamma = glm::dot(ray.direction, q) / determinant;
    hit.distance = glm::dot(triangle.alongRow, q) / determinant;
    hit.inside = std::min({hit.beta, hit.gamma, 1 - hit.beta - hit.gamma});
    return hit;
}

/// A hit inside its triangle beats one outside; of two inside the nearer to Embree's distance, of two outside
/// the less so.
bool better(const Intersection& a, const Intersection& b, double distance) {
    if (a.inside >= 0 && b.inside >= 0)
        return std::abs(a.distance - distance) < std::abs(b.distance - distance);
    return a.inside > b.inside;
}

Triangle triangleOf(const MicroMesh& mesh, const MicroGrid& grid, int column, int row, bool upper) {
    const auto vertex = [&](int c, int r) {
        return Vec3(mesh.positionsWorld[grid.firstVertex + static_cast<uint32_t>(r * grid.columns + c)]);
    };
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

    Triangle triangle = triangleOf(mesh, grid, column, row, (x - column) + (y - row) > 1);
    Intersection hit = intersect(triangle, ray);
    if (hit.inside < 0) {
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, cellRows - 1); ++r)
            for (int c = std::max(column - 1, 0); c <= std::min(column + 1, cellColumns - 1); ++c)
                for (const bool upper : {false, true}) {
                    const Triangle other = triangleOf(mesh, grid, c, r, upper);
                    const Intersection otherHit = intersect(other, ray);
                    if (!better(otherHit, hit, distance)) continue;
                    triangle = other;
                    hit = otherHit;
                }
    }
    // Rays that graze an edge pass outside every triangle by rounding: the nearest point of the best one is
    // taken.
    const double beta = std::clamp(hit.beta, 0.0, 1.0), gamma = std::clamp(hit.gamma, 0.0, 1.0 - beta);
    ResolvedHit result;
    result.position = triangle.corner + beta * triangle.alongColumn + gamma * triangle.alongRow;
    result.distance = glm::dot(result.position - ray.origin, ray.direction);
    result.facetNormal = glm::normalize(glm::cross(triangle.alongColumn, triangle.alongRow));
    const PatchLattice& lattice = mesh.lattices[grid.patch];
    const Vec2 corner = latticeUv(lattice, triangle.column, triangle.row);
    result.uv = corner + beta * (latticeUv(lattice, triangle.column + triangle.sign, triangle.row) - corner) +
                gamma * (latticeUv(lattice, triangle.column, triangle.row + triangle.sign) - corner);
    return result;
}

} // namespace plumbline
