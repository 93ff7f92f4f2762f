// Contour edges of a micro-mesh as seen from somewhere: edges with a micro-triangle that faces the viewer on
// one side and one that faces away, or nothing, on the other. What is seen through a point changes only where
// a contour passes.
#pragma once

#include "reference/trace/screen.h"
#include "scenes/surface/micro_mesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace plumbline {

struct ContourEdge {
    Vec3 a, b;         // world
    Vec3 third;        // the other corner of a micro-triangle that ends there
    double errorWorld; // of the grids on both sides, the larger
};

class ContourFinder {
  public:
    /// The mesh must outlive it.
    explicit ContourFinder(const MicroMesh& mesh);

    /// Calls visit once for each contour edge, from many threads.
    void forEach(const Viewpoint& viewpoint, const std::function<void(const ContourEdge&)>& visit) const;

  private:
    /// A side of a micro-triangle with area, whose partner isn't known from the lattice: on the border of a
    /// patch, or beside triangles without area.
    struct LooseSide {
        uint64_t hash; // of the two ends' positions
        uint32_t a, b, third;
        uint32_t grid;
    };
    struct Triangle {
        uint32_t a, b, c; // vertices
    };
    /// Whether the micro-triangles of a grid's cells turn their fronts to a viewer (1), their backs (-1), or
    /// their edges (0); kNone for one without area.
    static constexpr int8_t kNone = 2;
    struct CellFacings {
        struct Cell {
            int8_t lower, upper;
        };
        std::array<Cell, (kMaxGridSide - 1) * (kMaxGridSide - 1)> cells;

        Cell& at(int column, int row) { return cells[indexIn(kMaxGridSide - 1, column, row)]; }
        const Cell& at(int column, int row) const { return cells[indexIn(kMaxGridSide - 1, column, row)]; }
    };

    Triangle triangle(uint32_t grid, int column, int row, bool upper) const;
    bool hasArea(const Triangle& triangle) const;
    int facing(const Viewpoint& viewpoint, const Triangle& triangle) const;
    bool touchesSide(const MicroGrid& grid) const;
    /// The grid beside one, of the same patch.
    std::optional<uint32_t> gridAt(uint32_t grid, int columnsAway, int rowsAway) const;
    /// Whether a cell of the lattice, in a grid or in one beside it, has that micro-triangle, with area.
    bool hasTriangle(uint32_t grid, int column, int row, bool upper) const;
    void collectLooseSides(uint32_t grid, std::vector<LooseSide>& sides) const;
    bool sameEnds(const LooseSide& s, const LooseSide& t) const;
    CellFacings facingsOf(const Viewpoint& viewpoint, uint32_t grid) const;
    void visitGrid(const Viewpoint& viewpoint, uint32_t grid,
                   const std::function<void(const ContourEdge&)>& visit) const;
    void visitLooseSides(const Viewpoint& viewpoint, size_t first, size_t end,
                         const std::function<void(const ContourEdge&)>& visit) const;
    ContourEdge edgeOf(uint32_t a, uint32_t b, uint32_t third, double errorWorld) const;

    const MicroMesh& mesh_;
    std::vector<uint32_t> firstGrid_; // per patch, and the end
    std::vector<LooseSide> loose_;    // by hash
    std::vector<size_t> runs_;        // first of each group of sides with the same ends, and the end
};

} // namespace plumbline
