// A micro-mesh without its repeated vertices: one number for each that differs from all others.
#pragma once

#include "scenes/surface/micro_mesh.h"

#include <functional>

namespace plumbline {

struct MeshNumbers {
    std::vector<uint32_t> ofVertex; // per vertex of the micro-mesh, from 0 in order of first appearance
    uint32_t vertexCount = 0;       // numbers given
    uint64_t triangleCount = 0;     // with three corners in different places
};

/// Vertices are one if position, normal and st are, bit for bit: grids repeat those on their borders, a
/// lattice those of its coarser sides. Where texture coordinates jump a place keeps a vertex for each of
/// them. The mesh must have attributes (MicroMesh::normalsWorld, st).
MeshNumbers numberVertices(const MicroMesh& mesh);

/// Calls visit(a, b, c) with indices into the micro-mesh for every micro-triangle whose corners are in three
/// places, grid by grid, counter-clockwise seen from outside.
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
