// The displaced surface of one object as micro-triangles: what reference/ traces, and what the control
// technique `micro_triangles` of realtime/ rasterizes. World space, float: these very floats are the geometry
// of both.
//
// A grid is a block of at most kMaxGridSide x kMaxGridSide vertices, row by row. Cell (column, row) has the
// corners
//     a = (column, row)   b = (column+1, row)   c = (column, row+1)   d = (column+1, row+1)
// and the micro-triangles a b c and d c b: its diagonal joins b and c, as Embree's RTC_GEOMETRY_TYPE_GRID has
// it. Vertices on borders between grids are repeated, bit for bit: each was computed once.
#pragma once

#include "scenes/core/index.h"
#include "scenes/core/math.h"

#include <array>
#include <cstdint>
#include <vector>

namespace plumbline {

inline constexpr int kMaxGridSide = 17; // 16 cells

/// The lattice of micro-vertices of one patch of the BaseSurface: columns x rows cells over its (u, v), both
/// powers of two. Each side has `sides` segments, a power of two not above the cells along it: where there
/// are fewer, the lattice's vertices on that side stand on the nearest end of a segment
/// (reference/tessellate/lattice.h), and meet the neighbor's there.
struct PatchLattice {
    uint16_t columns = 0, rows = 0;
    std::array<uint16_t, 4> sides{}; // at v = 0, u = 1, v = 1, u = 0; triangular: v = 0, the long side, u = 0
    bool triangular = false;         // u + v <= 1
};

struct MicroGrid {
    uint32_t firstVertex;   // into MicroMesh::positionsWorld; the grid's rows follow one another
    uint32_t patch;         // of the BaseSurface
    uint16_t columns, rows; // vertices
    uint16_t column0, row0; // place of the first vertex in the patch's lattice
    /// No point of the surface is farther from the place of the same (u, v) on the grid's micro-triangles, as
    /// far as reference/tessellate/tile.h can tell; world units.
    float errorWorld;
    /// Whether faces disagree about a vertex of it, so that the surface closes with a wall there
    /// (Seams::Weld).
    bool torn;

    /// Index into MicroMesh::positionsWorld of the vertex at a column and row of this grid.
    uint32_t vertex(int column, int row) const {
        return firstVertex + static_cast<uint32_t>(indexIn(columns, column, row));
    }
};

struct MicroMesh {
    std::vector<Vec3f> positionsWorld;
    std::vector<MicroGrid> grids;
    std::vector<PatchLattice> lattices; // one per patch
    /// Per vertex, filled on request only (the control technique and mesh files need them): unit normal of
    /// the displaced surface, at a crease that of one face, and the patch's own st.
    std::vector<Vec3f> normalsWorld;
    std::vector<Vec2f> st;
};

} // namespace plumbline
