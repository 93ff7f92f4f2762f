#include "reference/tessellate/map_deviation.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

// Coordinates within this distance of a crease count as on it: far above the rounding error of st * width
// (2^-52 of about 1e4) and far below anything visible.
constexpr double kOnCrease = 1e-9;
// For a triangle over more texels along an axis, the bound is the map's whole range, because traversing its
// texels would be too slow for such coarse cells.
constexpr double kMaxTexels = 64;

double lookUp(const HeightMap& map, const Vec2& texel) {
    const double i = std::floor(texel.x), j = std::floor(texel.y);
    const double x = texel.x - i, y = texel.y - j;
    const HeightMap::Cell cell = map.cell(static_cast<int>(i), static_cast<int>(j));
    const double lower = cell.d00 + (cell.d10 - cell.d00) * x;
    const double upper = cell.d01 + (cell.d11 - cell.d01) * x;
    return lower + (upper - lower) * y;
}

/// The mixed derivative of the bilinear patch that contains a point.
double twistAt(const HeightMap& map, const Vec2& texel) {
    const HeightMap::Cell cell =
        map.cell(static_cast<int>(std::floor(texel.x)), static_cast<int>(std::floor(texel.y)));
    return (cell.d11 - cell.d01) - (cell.d10 - cell.d00);
}

/// Whether a box lies within one bilinear patch.
bool withinPatch(const Vec2& low, const Vec2& high) {
    const Vec2 patch = glm::floor(low + kOnCrease);
    return high.x <= patch.x + 1 + kOnCrease && high.y <= patch.y + 1 + kOnCrease;
}

/// Whether the box has few enough texels to traverse, with indices that fit an int.
bool isSmall(const Vec2& low, const Vec2& high) {
    constexpr double kLargestNumber = 1e9;
    const Vec2 size = high - low, farthest = glm::max(glm::abs(low), glm::abs(high));
    return size.x <= kMaxTexels && size.y <= kMaxTexels && farthest.x < kLargestNumber &&
           farthest.y < kLargestNumber;
}

/// Largest deviation of a bilinear patch from its chord along (x, y) texels, per unit of its mixed
/// derivative.
double bow(const Vec2& along) {
    return std::abs(along.x * along.y) / 4;
}

/// A bound on the deviation over any triangle within a box of few texels; infinite for more. With g0 the
/// center of the range of gradients, f minus the plane is sum w_k (integral of (g - g0) . (x - x_k)), and sum
/// w_k |x - x_k| is at most half the box's side.
double deviationAtMost(const HeightMap& map, const Vec2& low, const Vec2& high) {
    constexpr double kFew = 3;
    if (high.x - low.x > kFew || high.y - low.y > kFew) return kInfinity;
    Vec2 least(kInfinity), most(-kInfinity);
    const int right = static_cast<int>(std::ceil(high.x - kOnCrease)),
              top = static_cast<int>(std::ceil(high.y - kOnCrease));
    for (int j = static_cast<int>(std::floor(low.y + kOnCrease)); j < top; ++j)
        for (int i = static_cast<int>(std::floor(low.x + kOnCrease)); i < right; ++i) {
            const HeightMap::Cell cell = map.cell(i, j);
            for (const Vec2& gradient : {Vec2(cell.d10 - cell.d00, cell.d01 - cell.d00),
                                         Vec2(cell.d11 - cell.d01, cell.d11 - cell.d10)}) {
                least = glm::min(least, gradient);
                most = glm::max(most, gradient);
            }
        }
    const Vec2 bound = (most - least) * (high - low) / 4.0;
    return bound.x + bound.y;
}

/// A triangle and the plane through its corners' depths.
struct LinearTriangle {
    const std::array<MapPoint, 3>& p;
    Vec2 ab, ac;
    double area; // twice, signed

    explicit LinearTriangle(const std::array<MapPoint, 3>& corners)
        : p(corners), ab(corners[1].texel - corners[0].texel), ac(corners[2].texel - corners[0].texel),
          area(ab.x * ac.y - ab.y * ac.x) {}
    /// Weights of corners b and c at a point.
    Vec2 weights(const Vec2& at) const {
        const Vec2 offset = at - p[0].texel;
        return {(offset.x * ac.y - offset.y * ac.x) / area, (ab.x * offset.y - ab.y * offset.x) / area};
    }
};

/// Largest |q| over [0, 1] of the parabola with the values `first` and `last` at its ends and the leading
/// coefficient `square`.
double largestOfParabola(double first, double last, double square) {
    double largest = std::max(std::abs(first), std::abs(last));
    const double slope = last - first - square; // q = first + slope x + square x^2
    const double vertex = -slope / (2 * square);
    if (vertex > 0 && vertex < 1)
        largest = std::max(largest, std::abs(first + vertex * (slope + square * vertex)));
    return largest;
}

/// Largest deviation along one edge: at the creases and between them.
double edgeDeviation(const HeightMap& map, const MapPoint& from, const MapPoint& to) {
    const Vec2 along = to.texel - from.texel;
    double worst = 0;
    // Merges the crossings with creases along both axes, each of which is already sorted.
    const auto nextCrossing = [&](int axis, double t) {
        if (along[axis] == 0) return 2.0;
        const double at = from.texel[axis] + t * along[axis];
        const double crease =
            along[axis] > 0 ? std::floor(at + kOnCrease) + 1 : std::ceil(at - kOnCrease) - 1;
        return (crease - from.texel[axis]) / along[axis];
    };
    double t = 0;
    while (t < 1) {
        const double next = std::min({nextCrossing(0, t), nextCrossing(1, t), 1.0});
        const Vec2 middle = from.texel + 0.5 * (t + next) * along;
        const auto off = [&](double where) {
            return lookUp(map, from.texel + where * along) - (from.depth + where * (to.depth - from.depth));
        };
        worst = std::max(
            worst, largestOfParabola(off(t), off(next),
                                     twistAt(map, middle) * along.x * along.y * (next - t) * (next - t)));
        t = next;
    }
    return worst;
}

/// Largest deviation at the texel centers inside.
double centerDeviation(const HeightMap& map, const LinearTriangle& triangle, const Vec2& low,
                       const Vec2& high) {
    double worst = 0;
    for (double j = std::ceil(low.y); j <= high.y; ++j)
        for (double i = std::ceil(low.x); i <= high.x; ++i) {
            const Vec2 weights = triangle.weights({i, j});
            if (!(weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1)) continue;
            const auto& p = triangle.p;
            const double plane =
                p[0].depth + weights.x * (p[1].depth - p[0].depth) + weights.y * (p[2].depth - p[0].depth);
            worst = std::max(worst, std::abs(map.texel(static_cast<int>(i), static_cast<int>(j)) - plane));
        }
    return worst;
}

} // namespace

double triangleDeviation(const HeightMap& map, const std::array<MapPoint, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vec2 low = glm::min(glm::min(a.texel, b.texel), c.texel);
    const Vec2 high = glm::max(glm::max(a.texel, b.texel), c.texel);
    if (!isSmall(low, high)) {
        const double least = std::min({a.depth, b.depth, c.depth});
        const double most = std::max({a.depth, b.depth, c.depth});
        return std::max(most - map.minDepth(), map.maxDepth() - least);
    }
    if (withinPatch(low, high))
        return std::abs(twistAt(map, 0.5 * (low + high))) *
               std::max({bow(b.texel - a.texel), bow(c.texel - b.texel), bow(a.texel - c.texel)});
    double worst = 0;
    for (size_t k = 0; k < 3; ++k)
        worst = std::max(worst, edgeDeviation(map, corners[k], corners[(k + 1) % 3]));
    const LinearTriangle triangle(corners);
    if (triangle.area != 0) worst = std::max(worst, centerDeviation(map, triangle, low, high));
    return worst;
}

double cellDeviation(const HeightMap& map, const MapPoint& a, const MapPoint& b, const MapPoint& c,
                     const MapPoint& d, double enough) {
    const Vec2 low = glm::min(glm::min(a.texel, b.texel), glm::min(c.texel, d.texel));
    const Vec2 high = glm::max(glm::max(a.texel, b.texel), glm::max(c.texel, d.texel));
    if (isSmall(low, high)) {
        if (withinPatch(low, high))
            return std::abs(twistAt(map, 0.5 * (low + high))) *
                   std::max({bow(b.texel - a.texel), bow(c.texel - a.texel), bow(c.texel - b.texel),
                             bow(d.texel - b.texel), bow(d.texel - c.texel)});
        if (deviationAtMost(map, low, high) <= enough) return enough;
    }
    return std::max(triangleDeviation(map, {a, b, c}), triangleDeviation(map, {d, c, b}));
}

} // namespace plumbline
