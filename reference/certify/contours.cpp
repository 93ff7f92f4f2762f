#include "reference/certify/contours.h"

#include "reference/tessellate/lattice.h"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <bit>
#include <tuple>

namespace plumbline {

namespace {

/// Mixes the bits of a position; the same for the same floats.
uint64_t hashOf(const Vec3f& p) {
    uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // + 0 makes one zero of both.
        hash ^= std::bit_cast<uint32_t>(p[axis] + 0.0f);
        hash *= 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

/// 1 if a triangle turns its front to the viewer, -1 its back, 0 its edge.
int8_t facingOf(const Viewpoint& viewpoint, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double toward = glm::dot(glm::cross(b - a, c - a), viewpoint.toward(a));
    return static_cast<int8_t>((toward > 0) - (toward < 0));
}

} // namespace

ContourFinder::ContourFinder(const MicroMesh& mesh) : mesh_(mesh) {
    firstGrid_.assign(mesh.lattices.size() + 1, static_cast<uint32_t>(mesh.grids.size()));
    for (size_t grid = mesh.grids.size(); grid-- > 0;)
        firstGrid_[mesh.grids[grid].patch] = static_cast<uint32_t>(grid);
    tbb::combinable<std::vector<LooseSide>> collected;
    tbb::parallel_for(uint32_t(0), static_cast<uint32_t>(mesh.grids.size()),
                      [&](uint32_t grid) { collectLooseSides(grid, collected.local()); });
    collected.combine_each([&](const std::vector<LooseSide>& sides) {
        loose_.insert(loose_.end(), sides.begin(), sides.end());
    });
    tbb::parallel_sort(loose_.begin(), loose_.end(), [](const LooseSide& s, const LooseSide& t) {
        return std::tie(s.hash, s.a, s.b) < std::tie(t.hash, t.a, t.b);
    });
    for (size_t i = 0; i < loose_.size(); ++i)
        if (i == 0 || loose_[i].hash != loose_[i - 1].hash || !sameEnds(loose_[i], loose_[i - 1]))
            runs_.push_back(i);
    runs_.push_back(loose_.size());
}

ContourFinder::Triangle ContourFinder::triangle(uint32_t gridIndex, int column, int row, bool upper) const {
    const MicroGrid& grid = mesh_.grids[gridIndex];
    const uint32_t a = grid.vertex(column, row), b = a + 1, c = a + grid.columns;
    return upper ? Triangle{c + 1, c, b} : Triangle{a, b, c};
}

bool ContourFinder::hasArea(const Triangle& t) const {
    const auto& p = mesh_.positionsWorld;
    return p[t.a] != p[t.b] && p[t.b] != p[t.c] && p[t.c] != p[t.a];
}

int ContourFinder::facing(const Viewpoint& viewpoint, const Triangle& t) const {
    const auto& p = mesh_.positionsWorld;
    return facingOf(viewpoint, Vec3(p[t.a]), Vec3(p[t.b]), Vec3(p[t.c]));
}

bool ContourFinder::touchesSide(const MicroGrid& grid) const {
    const PatchLattice& lattice = mesh_.lattices[grid.patch];
    return grid.column0 == 0 || grid.row0 == 0 || grid.row0 + grid.rows - 1 == lattice.rows ||
           grid.column0 + grid.columns - 1 == lattice.columns || lattice.triangular;
}

std::optional<uint32_t> ContourFinder::gridAt(uint32_t index, int columnsAway, int rowsAway) const {
    const MicroGrid& grid = mesh_.grids[index];
    const PatchLattice& lattice = mesh_.lattices[grid.patch];
    const int column = grid.column0 / kGridCells + columnsAway, row = grid.row0 / kGridCells + rowsAway;
    if (column < 0 || row < 0 || row >= blocksAlong(lattice.rows) || column >= blocksInRow(lattice, row))
        return std::nullopt;
    int before = 0;
    for (int r = 0; r < row; ++r)
        before += blocksInRow(lattice, r);
    return firstGrid_[grid.patch] + static_cast<uint32_t>(before + column);
}

bool ContourFinder::hasTriangle(uint32_t index, int column, int row, bool upper) const {
    const MicroGrid& grid = mesh_.grids[index];
    const PatchLattice& lattice = mesh_.lattices[grid.patch];
    if (column < 0 || row < 0 || column >= lattice.columns || row >= lattice.rows) return false;
    const auto away = [](int cell, int cells) { return cell < 0 ? -1 : cell >= cells ? 1 : 0; };
    const int columns = away(column - grid.column0, grid.columns - 1),
              rows = away(row - grid.row0, grid.rows - 1);
    const auto of = columns == 0 && rows == 0 ? std::optional(index) : gridAt(index, columns, rows);
    if (!of) return false;
    const MicroGrid& holder = mesh_.grids[*of];
    return hasArea(triangle(*of, column - holder.column0, row - holder.row0, upper));
}

void ContourFinder::collectLooseSides(uint32_t index, std::vector<LooseSide>& sides) const {
    const MicroGrid& grid = mesh_.grids[index];
    if (!touchesSide(grid)) return;
    const auto add = [&](uint32_t a, uint32_t b, uint32_t third) {
        sides.push_back(
            {hashOf(mesh_.positionsWorld[a]) + hashOf(mesh_.positionsWorld[b]), a, b, third, index});
    };
    for (int r = 0; r + 1 < grid.rows; ++r)
        for (int c = 0; c + 1 < grid.columns; ++c) {
            const int column = grid.column0 + c, row = grid.row0 + r;
            const Triangle lower = triangle(index, c, r, false), upper = triangle(index, c, r, true);
            const bool hasLower = hasArea(lower), hasUpper = hasArea(upper);
            if (hasLower) {
                if (!hasTriangle(index, column, row - 1, true)) add(lower.a, lower.b, lower.c);
                if (!hasTriangle(index, column - 1, row, true)) add(lower.c, lower.a, lower.b);
                if (!hasUpper) add(lower.b, lower.c, lower.a);
            }
            if (hasUpper) {
                if (!hasTriangle(index, column, row + 1, false)) add(upper.a, upper.b, upper.c);
                if (!hasTriangle(index, column + 1, row, false)) add(upper.c, upper.a, upper.b);
                if (!hasLower) add(upper.b, upper.c, upper.a);
            }
        }
}

bool ContourFinder::sameEnds(const LooseSide& s, const LooseSide& t) const {
    const auto& p = mesh_.positionsWorld;
    return (p[s.a] == p[t.a] && p[s.b] == p[t.b]) || (p[s.a] == p[t.b] && p[s.b] == p[t.a]);
}

ContourEdge ContourFinder::edgeOf(uint32_t a, uint32_t b, uint32_t third, double errorWorld) const {
    return {Vec3(mesh_.positionsWorld[a]), Vec3(mesh_.positionsWorld[b]), Vec3(mesh_.positionsWorld[third]),
            errorWorld};
}

ContourFinder::CellFacings ContourFinder::facingsOf(const Viewpoint& viewpoint, uint32_t index) const {
    const MicroGrid& grid = mesh_.grids[index];
    std::array<Vec3, kMaxGridSide * kMaxGridSide> points;
    for (uint32_t i = 0; i < uint32_t(grid.columns) * grid.rows; ++i)
        points[i] = Vec3(mesh_.positionsWorld[grid.firstVertex + i]);
    CellFacings facings;
    // Without area there are only some along a patch's sides.
    const bool allHaveArea = !touchesSide(grid);
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column) {
            const Vec3* a = &points[indexIn(grid.columns, column, row)];
            const Vec3 &b = a[1], &c = a[grid.columns], &d = a[grid.columns + 1];
            auto& [lower, upper] = facings.at(column, row);
            lower = facingOf(viewpoint, *a, b, c);
            upper = facingOf(viewpoint, d, c, b);
            if (allHaveArea) continue;
            if (!hasArea(triangle(index, column, row, false))) lower = kNone;
            if (!hasArea(triangle(index, column, row, true))) upper = kNone;
        }
    return facings;
}

void ContourFinder::visitGrid(const Viewpoint& viewpoint, uint32_t index,
                              const std::function<void(const ContourEdge&)>& visit) const {
    const MicroGrid& grid = mesh_.grids[index];
    const CellFacings facings = facingsOf(viewpoint, index);
    const std::optional<uint32_t> below = gridAt(index, 0, -1), left = gridAt(index, -1, 0);
    // A triangle seen exactly edge-on counts as turned from both sides.
    const auto consider = [&](int one, int other, uint32_t a, uint32_t b, uint32_t third, double error) {
        if (one != kNone && other != kNone && (one != other || one == 0)) visit(edgeOf(a, b, third, error));
    };
    // The same with the upper triangle of a cell of the grid before this one.
    const auto considerWith = [&](uint32_t gridBefore, int column, int row, int one, uint32_t a, uint32_t b,
                                  uint32_t third) {
        const Triangle other = triangle(gridBefore, column, row, true);
        consider(one, hasArea(other) ? facing(viewpoint, other) : kNone, a, b, third,
                 std::max(grid.errorWorld, mesh_.grids[gridBefore].errorWorld));
    };
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column) {
            const auto& [lower, upper] = facings.at(column, row);
            const Triangle t = triangle(index, column, row, false);
            consider(lower, upper, t.b, t.c, t.a, grid.errorWorld);
            if (row > 0)
                consider(lower, facings.at(column, row - 1).upper, t.a, t.b, t.c, grid.errorWorld);
            else if (below)
                considerWith(*below, column, mesh_.grids[*below].rows - 2, lower, t.a, t.b, t.c);
            if (column > 0)
                consider(lower, facings.at(column - 1, row).upper, t.c, t.a, t.b, grid.errorWorld);
            else if (left)
                considerWith(*left, mesh_.grids[*left].columns - 2, row, lower, t.c, t.a, t.b);
        }
}

void ContourFinder::visitLooseSides(const Viewpoint& viewpoint, size_t first, size_t end,
                                    const std::function<void(const ContourEdge&)>& visit) const {
    const auto facingOf = [&](const LooseSide& side) {
        return facing(viewpoint, {side.a, side.b, side.third});
    };
    double error = 0;
    for (size_t i = first; i < end; ++i)
        error = std::max(error, double(mesh_.grids[loose_[i].grid].errorWorld));
    const LooseSide& side = loose_[first];
    const int one = facingOf(side);
    if (end - first == 2 && one != 0 && facingOf(loose_[first + 1]) == one) return;
    visit(edgeOf(side.a, side.b, side.third, error));
}

void ContourFinder::forEach(const Viewpoint& viewpoint,
                            const std::function<void(const ContourEdge&)>& visit) const {
    tbb::parallel_for(uint32_t(0), static_cast<uint32_t>(mesh_.grids.size()),
                      [&](uint32_t grid) { visitGrid(viewpoint, grid, visit); });
    if (runs_.size() < 2) return;
    tbb::parallel_for(size_t(0), runs_.size() - 1,
                      [&](size_t run) { visitLooseSides(viewpoint, runs_[run], runs_[run + 1], visit); });
}

} // namespace plumbline
