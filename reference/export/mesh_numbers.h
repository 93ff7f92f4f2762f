// Numbers the distinct vertices of a micro-mesh.
#pragma once

#include "scenes/surface/micro_mesh.h"

#include <functional>

namespace plumbline {

struct MeshNumbers {
    std::vector<uint32_t> ofVertex; // per micro-vertex, from 0 in order of first occurrence
    uint32_t vertexCount = 0;       // distinct vertices
    uint64_t triangleCount = 0;     // with three different positions
};

/// Vertices are merged if position, normal and st are bit-identical: grids duplicate the vertices on their
/// borders, and a lattice those on its coarser sides. At a texture seam, a position keeps one vertex for each
/// st, and at a crease one for each normal. The mesh must have attributes (MicroMesh::normalsWorld, st).
MeshNumbers numberVertices(const MicroMesh& mesh);

/// Calls visit(a, b, c) with indices into the micro-mesh for every micro-triangle with three different
/// positions, grid by grid, counterclockwise seen from outside.
template <class Visit>
void forTriangles(const MicroMesh& mesh, Visit&& visit) {
    const auto keep = [&](uint32_t a, uint32_t b, uint32_t c) {
        const auto &p = mesh.positionsWorld[a], &q = mesh.positionsWorld[b], &r = mesh.positionsWorld[c];
        if (p != q && q != r && r != p) visit(a, b, c);
    };
    for (const MicroGrid& grid : mesh.grids)
        for (uint32_t row = 0; row + 1 < grid.rows; ++row)
            for (uint32_t column = 0; column + 1 < grid.columns; ++column) {
                const uint32_t a = grid.firstVertex + row * grid.columns + column, c = a + grid.columns;
                keep(a, a + 1, c);
                keep(c + 1, c, a + 1);
            }
}

} // namespace plumbline
