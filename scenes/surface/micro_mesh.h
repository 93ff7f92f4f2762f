// The displaced surface of one object as micro-triangles, which reference/ traces and the control technique
// `micro_triangles` of realtime/ rasterizes. World space, float; both use exactly these values.
//
// A grid is a block of at most kMaxGridSide x kMaxGridSide vertices, row by row. Cell (column, row) has the
// corners
//     a = (column, row)   b = (column+1, row)   c = (column, row+1)   d = (column+1, row+1)
// and the micro-triangles a b c and d c b: the diagonal connects b and c, as in Embree's
// RTC_GEOMETRY_TYPE_GRID. Vertices on borders between grids are duplicated with identical bits, because each
// is computed once.
#pragma once

#include "scenes/core/index.h"
#include "scenes/core/math.h"

#include <array>
#include <cstdint>
#include <vector>

namespace plumbline {

inline constexpr int kMaxGridSide = 17; // 16 cells

/// The lattice of micro-vertices of one patch of the BaseSurface: columns x rows cells over its (u, v), both
/// powers of two. Each side has `sides` segments, a power of two not larger than the number of cells along
/// it. If it is smaller, the lattice's vertices on that side are snapped to the nearest segment end
/// (reference/tessellate/lattice.h), so that they coincide with the neighbor's vertices.
struct PatchLattice {
    uint16_t columns = 0, rows = 0;
    std::array<uint16_t, 4> sides{}; // at v = 0, u = 1, v = 1, u = 0; triangular: v = 0, u + v = 1, u = 0
    bool triangular = false;         // u + v <= 1
};

struct MicroGrid {
    uint32_t firstVertex;   // into MicroMesh::positionsWorld; the grid's rows follow one another
    uint32_t patch;         // of the BaseSurface
    uint16_t columns, rows; // vertices
    uint16_t column0, row0; // position of the first vertex in the patch's lattice
    /// Bound on the distance between a point of the surface and the point with the same (u, v) on the grid's
    /// micro-triangles, estimated as described in reference/tessellate/tile.h; world units.
    float errorWorld;
    /// Whether faces displace one of its vertices differently, so that welding (Seams::Weld) adds a wall
    /// there.
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
    /// Per vertex, filled only on request, for the control technique and mesh files: the unit normal of the
    /// displaced surface and st, the patch's where those of its neighbors differ (at a crease, at a seam).
    std::vector<Vec3f> normalsWorld;
    std::vector<Vec2f> st;
};

} // namespace plumbline
