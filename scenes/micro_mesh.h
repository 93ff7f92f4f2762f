// The displaced surface of one object as micro-triangles: what reference/ traces, and what the control
// technique `micro_triangles` of realtime/ rasterises. World space, float: these very floats are the geometry
// of both.
//
// A grid is a block of at most kMaxGridSide x kMaxGridSide vertices, row by row. Cell (column, row) has the
// corners
//     a = (column, row)   b = (column+1, row)   c = (column, row+1)   d = (column+1, row+1)
// and the micro-triangles a b c and d c b: its diagonal joins b and c, as Embree's RTC_GEOMETRY_TYPE_GRID has
// it. Vertices on borders between grids are repeated, bit for bit: each was computed once.
#pragma once

#include "math.h"

#include <cstdint>
#include <vector>

namespace plumbline {

inline constexpr int kMaxGridSide = 17; // 16 cells

struct MicroGrid {
    uint32_t firstVertex;   // into MicroMesh::positionsWorld; the grid's rows follow one another
    uint32_t patch;         // of the BaseSurface
    uint16_t columns, rows; // vertices
    uint32_t column0, row0; // place of the first vertex in the patch's lattice of `patchRate` segments a side
};

struct MicroMesh {
    std::vector<Vec3f> positionsWorld;
    std::vector<MicroGrid> grids;
    /// Per vertex, filled on request only (the control technique needs them): unit normal of the displaced
    /// surface and st.
    std::vector<Vec3f> normalsWorld;
    std::vector<Vec2f> st;
    int rate = 0; // segments per control edge, a power of two
    uint64_t microTriangleCount =
        0; // those with area in parameter space: half cells on a triangle's long side count once
};

} // namespace plumbline
