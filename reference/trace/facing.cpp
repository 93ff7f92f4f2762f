#include "reference/trace/facing.h"

#include "reference/tessellate/map_deviation.h"
#include "scenes/surface/displaced_surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumbline {

namespace {

// Maximum number of texels examined along an axis; for a larger region the result is "not certain".
constexpr double kMaxTexels = 24;
// Lower bound of the cosine for rays nearly parallel to the surface.
constexpr double kSmallestCosine = 1e-3;

/// Range of the gradients of the bilinear patches in a rectangle of texels, per texel.
struct GradientBox {
    Vec2 low{kInfinity}, high{-kInfinity};
    void add(double s, double t) {
        low = glm::min(low, Vec2(s, t));
        high = glm::max(high, Vec2(s, t));
    }
};

/// Returns false if the rectangle is too large.
bool gradientsWithin(const HeightMap& map, const Vec2& texel, const Vec2& radius, GradientBox& box) {
    constexpr double kLargestNumber = 1e9; // fits an int
    if (!(radius.x <= kMaxTexels / 2 && radius.y <= kMaxTexels / 2) ||
        !(std::abs(texel.x) < kLargestNumber && std::abs(texel.y) < kLargestNumber))
        return false;
    const Vec2 first = glm::floor(texel - radius), last = glm::floor(texel + radius);
    for (int j = static_cast<int>(first.y); j <= static_cast<int>(last.y); ++j)
        for (int i = static_cast<int>(first.x); i <= static_cast<int>(last.x); ++i) {
            const HeightMap::Cell cell = map.cell(i, j);
            box.add(cell.d10 - cell.d00, cell.d01 - cell.d00);
            box.add(cell.d11 - cell.d01, cell.d11 - cell.d10);
        }
    return true;
}

} // namespace

double reachAlongSurface(double errorWorld, double cosine) {
    const double across = std::max(std::abs(cosine), kSmallestCosine);
    // The ray enters the error slab above the surface and leaves it below.
    return errorWorld * (1 + 2 * std::sqrt(std::max(1 - cosine * cosine, 0.0)) / across);
}

bool facesThroughout(const BaseSample& base, const Relief* relief, double radiusWorld, const Vec3& toward,
                     double side) {
    assert(side == 1 || side == -1);
    if (base.singular) return false;
    const ReliefDirection k = sampleReliefDirection(base, relief);
    const AcrossRelief across = tangentsAcross(base, relief);
    const double area = glm::length(glm::cross(across.byU, across.byV));
    const double lengthU = glm::length(across.byU), lengthV = glm::length(across.byV);
    if (!(area > 0)) return false;
    // Extent of u and v within the radius.
    const double reachU = radiusWorld * lengthV / area, reachV = radiusWorld * lengthU / area;
    const double turn = glm::length(base.normalU) * reachU + glm::length(base.normalV) * reachV;
    const Vec2 st = textureCoordinates(base, relief);
    const double height = displacement(st, relief);
    const Vec3 a = base.positionU + k.alongU * height, b = base.positionV + k.alongV * height;
    const double level = side * glm::dot(glm::cross(a, b), toward);
    const double margin = turn * glm::length(a) * glm::length(b);
    if (!relief || relief->map->minDepth() == relief->map->maxDepth()) return level > margin;

    const HeightMap& map = *relief->map;
    const Vec2 size(map.width(), map.height());
    const Vec2 texelsU = relief->tile * base.uvU * size, texelsV = relief->tile * base.uvV * size;
    GradientBox box;
    if (!gradientsWithin(map, texelCoordinates(map, st),
                         glm::abs(texelsU) * reachU + glm::abs(texelsV) * reachV, box))
        return false;
    const double byHeightU = side * glm::dot(glm::cross(k.along, b), toward);
    const double byHeightV = side * glm::dot(glm::cross(a, k.along), toward);
    double least = kInfinity, steepest = 0;
    for (const double s : {box.low.x, box.high.x})
        for (const double t : {box.low.y, box.high.y}) {
            const Vec2 gradient(s, t);
            const double heightU = -relief->depth * glm::dot(gradient, texelsU);
            const double heightV = -relief->depth * glm::dot(gradient, texelsV);
            least = std::min(least, level + heightU * byHeightU + heightV * byHeightV);
            steepest = std::max({steepest, std::abs(heightU) * lengthV, std::abs(heightV) * lengthU});
        }
    return least > margin + turn * steepest;
}

} // namespace plumbline
