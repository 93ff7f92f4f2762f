#include "reference/tessellate/tile.h"

#include "scenes/surface/displaced_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumbline {

namespace {

// Safety factor for the deviation of the smooth base, which is only measured at the midpoints of edges of a
// few cells per grid. If a cell isn't small relative to the patch, the largest deviation is not at the
// midpoint (for a cubic it is up to 1.3 times larger), and it may be larger between the measured cells.
constexpr double kBowMargin = 1.5;
// A direction whose middle along an edge is farther from the mean of both ends than this fraction of their
// difference jumps there: 1/2 at a jump in a vertex, less than 1/4 for arcs of up to 106 degrees.
constexpr double kJumpFraction = 0.25;
// Distance between measured cells, in cells.
constexpr int kBowStride = 8;
// Rounding of a normal near a point where S_u and S_v become parallel.
constexpr double kNormalRounding = 0x1p-20;
// The vertices are stored as floats, whose coordinates are rounded by a factor of 2^-24 each.
constexpr double kFloatRounding = 0x1p-23;

TileVertex sampleVertex(const BaseSurface::Evaluator& evaluator, const Relief* relief, const Vec2& uv) {
    const BasePoint point = evaluator.point(uv.x, uv.y);
    TileVertex vertex;
    vertex.base = point.position;
    vertex.direction = reliefDirection(point, relief);
    if (!relief) return vertex;
    const Vec2 st = textureCoordinates(point, relief);
    vertex.map = {texelCoordinates(*relief->map, st), relief->map->depth(st)};
    vertex.height = relief->offset - relief->depth * vertex.map.depth;
    return vertex;
}

/// Tile::bend. st is bilinear in (u, v), and u v deviates from linear by 1/4 of its change over a cell in the
/// cell's center.
Vec2 bendOfCells(const PatchLattice& lattice, const Relief& relief, const BaseSurface::Evaluator& evaluator) {
    const auto st = [&](double u, double v) { return textureCoordinates(evaluator.point(u, v), &relief); };
    const Vec2 twist = st(0, 0) + st(1, 1) - st(1, 0) - st(0, 1);
    const Vec2 texels = glm::abs(twist) * Vec2(relief.map->width(), relief.map->height());
    return texels / (4.0 * lattice.columns * lattice.rows);
}

/// Deviations of S and k from linear along one edge of a cell.
struct Bows {
    double base = 0, direction = 0;
    void add(const TileVertex& from, const TileVertex& to, const BasePoint& middle, const Relief* relief) {
        base = std::max(base, glm::length(middle.position - 0.5 * (from.base + to.base)));
        const Vec3 along = reliefDirection(middle, relief);
        direction = std::max(direction, glm::length(along - 0.5 * (from.direction + to.direction)));
    }
    /// Counts the edge only where it bows by more than the margin over regular ones covers. A direction that
    /// jumps along it counts with all of its jump.
    void addIrregular(const TileVertex& from, const TileVertex& to, const BasePoint& middle,
                      const Relief* relief, const Bows& regular, bool corners) {
        Bows edge;
        edge.add(from, to, middle, relief);
        const double jump = glm::length(to.direction - from.direction);
        if (edge.direction > kJumpFraction * jump + kNormalRounding)
            direction = std::max({direction, jump, edge.direction});
        else if (corners && edge.direction > kBowMargin * regular.direction)
            direction = std::max(direction, edge.direction);
        if (corners && edge.base > kBowMargin * regular.base) base = std::max(base, edge.base);
    }
};

class TileMeasure {
  public:
    TileMeasure(const Tile& tile, const PatchLattice& lattice, const Relief* relief,
                const BaseSurface::Evaluator& evaluator, bool corners)
        : tile_(tile), lattice_(lattice), relief_(relief), evaluator_(evaluator), corners_(corners) {
        if (relief) {
            const double low = relief->offset - relief->depth * relief->map->maxDepth();
            const double high = relief->offset - relief->depth * relief->map->minDepth();
            largestHeight_ = std::max(std::abs(low), std::abs(high));
        }
        for (int side = 0; side < (lattice.triangular ? 3 : 4); ++side)
            if (isCoarse(side))
                coarsest_ = std::max(coarsest_, std::max(lattice.columns, lattice.rows) /
                                                    double(item(lattice.sides, side)));
    }

    TileError error(int column0, int row0, int columns, int rows) {
        column0_ = column0, row0_ = row0, columns_ = columns, rows_ = rows;
        measureBase();
        measureIrregular();
        double map = 0, heightRange = 0, tear = 0, coordinate = 0;
        for (int row = row0; row < row0 + rows; ++row)
            for (int column = column0; column < column0 + columns; ++column) {
                const TileVertex &a = tile_.at(column, row), &b = tile_.at(column + 1, row),
                                 &c = tile_.at(column, row + 1), &d = tile_.at(column + 1, row + 1);
                const double least = std::min({a.height, b.height, c.height, d.height});
                const double most = std::max({a.height, b.height, c.height, d.height});
                heightRange = std::max(heightRange, most - least);
                if (relief_)
                    map = std::max(map, cellDeviation(*relief_->map, a.map, b.map, c.map, d.map, map));
                tear = std::max({tear, tear_(column, row), tear_(column + 1, row), tear_(column, row + 1),
                                 tear_(column + 1, row + 1)});
            }
        const Vec3 corner = glm::abs(tile_.at(column0, row0).base);
        coordinate = std::max({corner.x, corner.y, corner.z}) + columns_ * largestCell_;
        const double bow = kBowMargin * (bows_.base + bows_.direction * largestHeight_);
        const double covariance = 0.25 * kBowMargin * directionRange_ * heightRange;
        const double depth = relief_ ? relief_->depth : 0;
        if (relief_)
            map += (tile_.bend.x + tile_.bend.y) * coarsest_ *
                   (relief_->map->maxDepth() - relief_->map->minDepth());
        // At a tear, the true surface is a wall between the two heights, and its distance from a welded cell
        // is at most the cell's width.
        const double rounding = kFloatRounding * coordinate;
        return {bow + depth * map + covariance + std::min(tear, largestCell_) + rounding,
                tear > 4 * rounding};
    }

  private:
    double tear_(int column, int row) const { return tile_.tears[tile_.index(column, row)]; }

    /// The base at the midpoint, in (u, v), of two lattice vertices.
    BasePoint middle(int column, int row, int toColumn, int toRow) const {
        const Vec2 uv = 0.5 * (latticeUv(lattice_, tile_.column0 + column, tile_.row0 + row) +
                               latticeUv(lattice_, tile_.column0 + toColumn, tile_.row0 + toRow));
        return evaluator_.point(uv.x, uv.y);
    }

    void addEdge(int column, int row, int toColumn, int toRow) {
        const TileVertex &from = tile_.at(column, row), &to = tile_.at(toColumn, toRow);
        if (from.base == to.base) return; // snapped to the same position
        bows_.add(from, to, middle(column, row, toColumn, toRow), relief_);
        directionRange_ = std::max(directionRange_, glm::length(from.direction - to.direction));
        largestCell_ = std::max(largestCell_, glm::length(from.base - to.base));
    }

    void measureBase() {
        bows_ = {};
        directionRange_ = largestCell_ = 0;
        const int stride = std::clamp(std::min(columns_, rows_) / 2, 1, kBowStride);
        for (int row = row0_ + stride / 2; row < row0_ + rows_; row += stride)
            for (int column = column0_ + stride / 2; column < column0_ + columns_; column += stride) {
                addEdge(column, row, column + 1, row);
                addEdge(column, row, column, row + 1);
                addEdge(column + 1, row, column, row + 1);
                // The far sides belong to no other cell of the grid. A flat face bounded by curves bows only
                // there.
                if (column == column0_ + columns_ - 1) addEdge(column + 1, row, column + 1, row + 1);
                if (row == row0_ + rows_ - 1) addEdge(column, row + 1, column + 1, row + 1);
            }
        // Cells along a side with fewer samples than steps are as wide as the distance between samples.
        for (int side = 0; side < (lattice_.triangular ? 3 : 4); ++side)
            if (isCoarse(side)) measureSide(side);
    }

    /// What the measured cells may miss: a corner of the patch, where S may be singular, and a direction that
    /// jumps at a single vertex, as at a cusp or by a wrong normal, around which it turns fastest.
    void measureIrregular() {
        const Bows regular = bows_;
        const int columns[] = {column0_, column0_ + columns_}, rows[] = {row0_, row0_ + rows_};
        for (const int column : columns)
            for (const int row : rows)
                if (isPatchCorner(column, row)) addIrregularAround(column, row, regular);
        if (!relief_ || relief_->axisWorld) return;
        const Vec2i turn = sharpestTurn();
        if (turn.x >= 0) addIrregularAround(turn.x, turn.y, regular);
    }

    bool isPatchCorner(int column, int row) const {
        const int x = tile_.column0 + column, y = tile_.row0 + row;
        return (x == 0 || x == lattice_.columns) && (y == 0 || y == lattice_.rows) &&
               !(lattice_.triangular && x + y > lattice_.columns);
    }

    /// The vertex where the direction's second difference along the columns or rows is largest; negative
    /// where there is none.
    Vec2i sharpestTurn() const {
        Vec2i sharpest(-1);
        double most = kNormalRounding;
        const auto consider = [&](int column, int row, int alongColumns, int alongRows) {
            const Vec3 turn = tile_.at(column - alongColumns, row - alongRows).direction +
                              tile_.at(column + alongColumns, row + alongRows).direction -
                              2.0 * tile_.at(column, row).direction;
            if (const double size = glm::dot(turn, turn); size > most) {
                most = size;
                sharpest = {column, row};
            }
        };
        for (int row = row0_; row <= row0_ + rows_; ++row)
            for (int column = column0_ + 1; column < column0_ + columns_; ++column)
                consider(column, row, 1, 0);
        for (int row = row0_ + 1; row < row0_ + rows_; ++row)
            for (int column = column0_; column <= column0_ + columns_; ++column)
                consider(column, row, 0, 1);
        return sharpest;
    }

    /// The edges of the cells around a vertex.
    void addIrregularAround(int column, int row, const Bows& regular) {
        const auto inside = [](int at, int first, int count) { return at >= first && at < first + count; };
        const auto add = [&](int c, int r, int toC, int toR) { addIrregular(c, r, toC, toR, regular); };
        for (const int r : {row - 1, row})
            for (const int c : {column - 1, column}) {
                if (!inside(c, column0_, columns_) || !inside(r, row0_, rows_)) continue;
                add(c, r, c + 1, r);
                add(c, r, c, r + 1);
                add(c + 1, r, c, r + 1);
                add(c + 1, r, c + 1, r + 1);
                add(c, r + 1, c + 1, r + 1);
            }
    }

    void addIrregular(int column, int row, int toColumn, int toRow, const Bows& regular) {
        const TileVertex &from = tile_.at(column, row), &to = tile_.at(toColumn, toRow);
        if (from.base == to.base) return; // snapped to the same position
        const double before = bows_.direction;
        bows_.addIrregular(from, to, middle(column, row, toColumn, toRow), relief_, regular, corners_);
        if (bows_.direction > before)
            directionRange_ = std::max(directionRange_, glm::length(from.direction - to.direction));
    }

    bool isCoarse(int side) const {
        const bool alongColumns = side % 2 == 0 && !(lattice_.triangular && side == 2);
        return item(lattice_.sides, side) < (alongColumns ? lattice_.columns : lattice_.rows);
    }

    void measureSide(int side) {
        for (int row = row0_; row <= row0_ + rows_; ++row)
            for (int column = column0_; column <= column0_ + columns_; ++column) {
                const int x = tile_.column0 + column, y = tile_.row0 + row;
                const bool on = lattice_.triangular ? (side == 0   ? y == 0
                                                       : side == 1 ? x + y == lattice_.columns
                                                                   : x == 0)
                                                    : (side == 0   ? y == 0
                                                       : side == 1 ? x == lattice_.columns
                                                       : side == 2 ? y == lattice_.rows
                                                                   : x == 0);
                if (!on) continue;
                const bool columnwise = lattice_.triangular ? side == 0 : side % 2 == 0;
                if (lattice_.triangular && side == 1) {
                    if (column > column0_ && row < row0_ + rows_) addEdge(column, row, column - 1, row + 1);
                } else if (columnwise && column < column0_ + columns_) {
                    addEdge(column, row, column + 1, row);
                } else if (!columnwise && row < row0_ + rows_) {
                    addEdge(column, row, column, row + 1);
                }
            }
    }

    const Tile& tile_;
    const PatchLattice& lattice_;
    const Relief* relief_;
    const BaseSurface::Evaluator& evaluator_;
    bool corners_;
    int column0_ = 0, row0_ = 0, columns_ = 0, rows_ = 0;
    Bows bows_;
    double directionRange_ = 0, largestCell_ = 0;
    double largestHeight_ = 0; // bound on |displacement|
    double coarsest_ = 1;      // width of a cell along a coarse side, in steps
};

} // namespace

void sampleTile(Tile& tile, const PatchLattice& lattice, const Relief* relief,
                const BaseSurface::Evaluator& evaluator) {
    tile.vertices.resize(areaOf(tile.columns + 1, tile.rows + 1));
    tile.tears.assign(tile.vertices.size(), 0);
    tile.bend = relief && !lattice.triangular ? bendOfCells(lattice, *relief, evaluator) : Vec2(0);
    for (int row = 0; row <= tile.rows; ++row)
        for (int column = 0; column <= tile.columns; ++column)
            tile.vertices[tile.index(column, row)] =
                sampleVertex(evaluator, relief, latticeUv(lattice, tile.column0 + column, tile.row0 + row));
}

TileError tileError(const Tile& tile, const PatchLattice& lattice, const Relief* relief,
                    const BaseSurface::Evaluator& evaluator, int column0, int row0, int columns, int rows,
                    bool corners) {
    assert(column0 >= 0 && column0 + columns <= tile.columns && row0 >= 0 && row0 + rows <= tile.rows);
    return TileMeasure(tile, lattice, relief, evaluator, corners).error(column0, row0, columns, rows);
}

} // namespace plumbline
