#include "realtime/bake/cone_near.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

// Relative tolerance for directions on the border of a half-plane.
constexpr double kOnBorder = 1e-12;

/// Directions e with normal . e >= 0 for each normal.
struct Directions {
    std::array<Vec2, 6> normals;
    int count = 0;
    void restrictTo(const Vec2& normal) { normals[static_cast<size_t>(count++)] = normal; }
    bool hold(const Vec2& e) const {
        for (int k = 0; k < count; ++k) {
            const Vec2& n = normals[static_cast<size_t>(k)];
            if (glm::dot(n, e) < -kOnBorder * (std::abs(n.x) + std::abs(n.y))) return false;
        }
        return true;
    }
};

/// Maximum of m . e over the unit directions e, which is attained along m or on a border; 0 if none is
/// positive.
double largestAlong(const Vec2& m, const Directions& directions) {
    const double length = glm::length(m);
    if (length == 0) return 0;
    if (directions.hold(m / length)) return length;
    double largest = 0;
    for (int k = 0; k < directions.count; ++k) {
        const Vec2 n = glm::normalize(directions.normals[static_cast<size_t>(k)]);
        for (const Vec2& e : {Vec2(-n.y, n.x), Vec2(n.y, -n.x)})
            if (glm::dot(m, e) > largest && directions.hold(e)) largest = glm::dot(m, e);
    }
    return largest;
}

std::array<Vec2, 4> corners(const CellSlopes& cell, const Vec2& texelsPerSt) {
    const auto st = [&](double s, double t) { return Vec2(s, t) * texelsPerSt; };
    return {st(cell.s.x, cell.t.x), st(cell.s.y, cell.t.x), st(cell.s.x, cell.t.y), st(cell.s.y, cell.t.y)};
}

/// The slopes of the 3 x 3 patches around a cell.
struct Neighborhood {
    std::array<CellSlopes, 9> cells;
    Vec2 texelsPerSt;
    const CellSlopes& at(int s, int t) const { return cells[static_cast<size_t>(3 * (t + 1) + s + 1)]; }
    std::array<Vec2, 4> gradients(int s, int t) const { return corners(at(s, t), texelsPerSt); }
};

Neighborhood neighborhood(const HeightMap& map, int column, int row) {
    Neighborhood n{{}, Vec2(map.width(), map.height())};
    double depths[4][4];
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            depths[j][i] = map.texel(column + i - 1, row + j - 1);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            n.cells[static_cast<size_t>(3 * j + i)] =
                cellSlopes({depths[j][i], depths[j][i + 1], depths[j + 1][i], depths[j + 1][i + 1]});
    return n;
}

/// Directions of chords from the middle cell into patch (s, t).
Directions leadingTo(int s, int t, int sector) {
    Directions directions;
    if (s != 0) directions.restrictTo(Vec2(s, 0));
    if (t != 0) directions.restrictTo(Vec2(0, t));
    if (sector == kAllDirections) return directions;
    const double sign = sector % 2 == 0 ? 1 : -1;
    for (const double side : {1.0, -1.0})
        directions.restrictTo(sector < 2 ? Vec2(sign, side) : Vec2(side, sign));
    return directions;
}

double steepestIn(const std::array<Vec2, 4>& gradients, const Directions& directions, double atLeast) {
    for (const Vec2& g : gradients)
        if (glm::dot(g, g) > atLeast * atLeast) atLeast = std::max(atLeast, largestAlong(-g, directions));
    return atLeast;
}

/// Whether a chord can descend more steeply than `atLeast` for gradient g, in a direction in which depth
/// increases for gradient `exit`. Without other constraints, the steepest direction is -g, or else orthogonal
/// to `exit`.
bool maySteepen(const Vec2& g, const Vec2& exit, double atLeast) {
    const double square = atLeast * atLeast;
    if (glm::dot(g, g) <= square) return false;
    const double across = g.x * exit.y - g.y * exit.x;
    return glm::dot(g, exit) < 0 || across * across > square * glm::dot(exit, exit);
}

} // namespace

double nearSlope(const HeightMap& map, const ConeRule& rule, int column, int row, int sector,
                 double atLeast) {
    const Neighborhood near = neighborhood(map, column, row);
    for (int t = -1; t <= 1; ++t)
        for (int s = -1; s <= 1; ++s) {
            const Directions directions = leadingTo(s, t, sector);
            if (!rule.relaxed) {
                atLeast = steepestIn(near.gradients(s, t), directions, atLeast);
                continue;
            }
            // The ray exits in patch (s, t), so the patch's depth increases along e: gradient . e > 0 for a
            // corner of its box.
            if (!exitPossible(near.at(s, t), s, t, rule.rayStart)) continue;
            for (const Vec2& exit : near.gradients(s, t)) {
                if (exit == Vec2(0)) continue;
                Directions leaving = directions;
                leaving.restrictTo(exit);
                for (const int passed : {0, 1, 2, 3})
                    for (const Vec2& g : near.gradients(passed & 1 ? s : 0, passed & 2 ? t : 0))
                        if (maySteepen(g, exit, atLeast))
                            atLeast = std::max(atLeast, largestAlong(-g, leaving));
            }
        }
    return atLeast;
}

} // namespace plumbline
