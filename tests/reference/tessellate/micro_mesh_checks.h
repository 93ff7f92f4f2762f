// Checks on the triangles of a micro-mesh: open edges and enclosed volume.
#pragma once

#include "scenes/surface/micro_mesh.h"

#include <array>
#include <map>

namespace plumbline {

using Triangle = std::array<Vec3f, 3>;

/// The micro-triangles, as defined by MicroGrid, whose corners differ.
inline std::vector<Triangle> trianglesWithArea(const MicroMesh& mesh) {
    std::vector<Triangle> triangles;
    const auto keep = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    };
    for (const MicroGrid& grid : mesh.grids)
        for (uint32_t row = 0; row + 1 < grid.rows; ++row)
            for (uint32_t column = 0; column + 1 < grid.columns; ++column) {
                const Vec3f* a = &mesh.positionsWorld[grid.firstVertex + row * grid.columns + column];
                keep(a[0], a[1], a[grid.columns]);
                keep(a[grid.columns + 1], a[grid.columns], a[1]);
            }
    return triangles;
}

/// The number of edges, identified by position, that don't have exactly one partner in the opposite
/// direction.
inline int unmatchedEdges(const std::vector<Triangle>& triangles) {
    std::map<std::array<float, 6>, int> edges;
    for (const Triangle& t : triangles)
        for (size_t k = 0; k < 3; ++k) {
            const Vec3f &a = t[k], &b = t[(k + 1) % 3];
            ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
            --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
        }
    int unmatched = 0;
    for (const auto& [edge, balance] : edges)
        unmatched += balance != 0;
    return unmatched;
}

inline double signedVolume(const std::vector<Triangle>& triangles) {
    double volume = 0;
    for (const Triangle& t : triangles)
        volume += glm::dot(Vec3(t[0]), glm::cross(Vec3(t[1]), Vec3(t[2]))) / 6;
    return volume;
}

} // namespace plumbline
